// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Functions of scripts that are sent, and collected later.
#include "script_bench.hpp"

#include <gmock/gmock.h>
#include <rtt/FactoryExceptions.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/OperationCallerC.hpp>
#include <unit/flow/log_capture.hpp>
#include <unit/operations/probe.hpp>
#include <unit/types/builtin_typekit.hpp>

#include <stdexcept>

using namespace RTT;
using oroforge::test::Probe;
using script_test::ScriptBench;

namespace {

/** Steps are made by update(). */
struct SentFunctions : types_test::WithBuiltinTypes {
    SentFunctions() {
        oroforge::test::makeManual(host);
        oroforge::test::makeManual(client);
        client.addPeer(&host);
        host.addAttribute("count", count);
        client.addAttribute("got", got);
        host.addOperation("fail", [] { throw std::runtime_error("the gripper is stuck"); });
        EXPECT_EQ(scripts.load("export int add(int a, int b) {\n  count = count + 1\n  return a + b\n}\n"
                               "export int slow(int a) {\n  yield\n  yield\n  return a * 10\n}\n"
                               "export void broken() {\n  fail()\n}\n"),
                  "");
    }
    OperationInterfacePart* part(const char* name) { return host.getOperation(name); }

    int count = 0, got = 0;
    flow_test::LogCapture log;
    Probe host{"host"}, client{"client"};
    ScriptBench scripts{host}, clientScripts{client};
};

TEST_F(SentFunctions, AreCollectedByTypedCallers) {
    OperationCaller<int(int, int)> add(part("add"), client.engine());
    SendHandle<int(int, int)> handle = add.send(3, 4), other = add.send(10, 20);
    ASSERT_TRUE(handle.ready()) << log.text();
    int result = 0;
    EXPECT_EQ(handle.collectIfDone(result), SendNotReady);
    EXPECT_EQ(count, 0) << "its component executes it";
    ASSERT_TRUE(host.update());
    EXPECT_EQ(handle.collectIfDone(result), SendSuccess);
    EXPECT_EQ(result, 7);
    EXPECT_EQ(other.collect(result), SendSuccess);
    EXPECT_EQ(result, 30);
    EXPECT_EQ(handle.collect(result), SendSuccess) << "again";
    EXPECT_EQ(result, 7);
}

TEST_F(SentFunctions, GoOnInLaterSteps) {
    internal::OperationCallerC slow(part("slow"), "slow", client.engine());
    internal::SendHandleC handle = slow.argC(4).send();
    int result = 0;
    handle.arg(result);
    EXPECT_EQ(handle.collectIfDone(), SendNotReady);
    ASSERT_TRUE(host.update());
    EXPECT_EQ(handle.collectIfDone(), SendNotReady) << "the message, and the functions of the first step";
    ASSERT_TRUE(host.update());
    EXPECT_EQ(handle.collectIfDone(), SendSuccess);
    EXPECT_EQ(result, 40);
}

TEST_F(SentFunctions, AreWaitedForByThreadsOfOthers) {
    Probe busy("busy");
    ScriptBench busyScripts(busy);
    busy.setPeriod(0.001);
    ASSERT_EQ(busyScripts.load("export int slow(int a) {\n  yield\n  yield\n  return a * 10\n}"), "");
    OperationCaller<int(int)> slow(busy.getOperation("slow"), client.engine());
    int result = 0;
    EXPECT_EQ(slow.send(7).collect(result), SendSuccess);
    EXPECT_EQ(result, 70);
    Probe collector("collector");
    auto handle = slow.send(8);
    std::atomic<int> collected{0};
    collector.onUpdate = [&] {
        int value = 0;
        if (handle.collect(value) == SendSuccess) collected = value;
    };
    ASSERT_TRUE(collector.start());
    EXPECT_TRUE(oroforge::test::eventually([&] { return collected == 80; })) << "sent by somebody else";
    collector.stop();
}

TEST_F(SentFunctions, AreExecutedByACollectorOfTheSameComponent) {
    OperationCaller<int(int)> slow(part("slow"), host.engine());
    int result = 0;
    SendStatus status = SendFailure;
    host.onUpdate = [&] {
        auto handle = slow.send(5);
        EXPECT_EQ(handle.collectIfDone(), SendNotReady);
        status = handle.collect(result);
    };
    ASSERT_TRUE(host.start());
    ASSERT_TRUE(host.update());
    EXPECT_EQ(status, SendSuccess);
    EXPECT_EQ(result, 50);
}

TEST_F(SentFunctions, AFailureIsLoggedAndThrownByTheCollector) {
    OperationCaller<void()> broken(part("broken"), client.engine());
    auto handle = broken.send();
    ASSERT_TRUE(host.update());
    const std::string failure = "function 'broken' of component 'host' failed at bench.ops:11:3: the gripper is stuck";
    EXPECT_THAT(log.text(), testing::HasSubstr("operation 'fail' threw in component 'host': the gripper is stuck\n"));
    EXPECT_THAT(log.text(),
                testing::EndsWith("\nbench.ops:11:3: error: [OPS400] function 'broken' of component 'host' failed: the "
                                  "gripper is stuck\n"));
    try {
        handle.collect();
        FAIL();
    } catch (const std::runtime_error& e) {
        EXPECT_EQ(e.what(), failure);
    }
    EXPECT_TRUE(host.inException()) << "the operation that threw is its own";
}

TEST_F(SentFunctions, OneThatWaitsForItselfFails) {
    SendHandle<void()> handle;
    host.addOperation("collectIt", [&handle] { handle.collect(); });
    ASSERT_EQ(scripts.load("export void selfish() {\n  collectIt()\n}\n"), "");
    handle = OperationCaller<void()>(part("selfish"), host.engine()).send();
    ASSERT_TRUE(host.update());
    EXPECT_TRUE(log.contains(
        "bench.ops:2:3: error: [OPS400] function 'selfish' of component 'host' failed: function 'selfish' of "
        "component 'host' waits for its own caller, which collects it here"))
        << log.text();
    EXPECT_THROW(handle.collect(), std::runtime_error);
}

TEST_F(SentFunctions, AreSentByProgramsWhichPoll) {
    ASSERT_EQ(clientScripts.load("program p {\n  var SendHandle h\n  h = host.slow.send(3)\n"
                                 "  while h.collectIfDone(got) == SendNotReady\n    yield\n}\n"),
              "");
    ASSERT_TRUE(clientScripts["p"].start());
    for (int step = 0; step != 2; ++step) {
        ASSERT_TRUE(client.update());
        EXPECT_TRUE(clientScripts["p"].isRunning()) << clientScripts["p"].getError();
        ASSERT_TRUE(host.update());
    }
    ASSERT_TRUE(client.update());
    EXPECT_EQ(got, 30);
    EXPECT_TRUE(clientScripts["p"].isStopped());
}

TEST_F(SentFunctions, AreCommandsThatAProgramWaitsFor) {
    ASSERT_EQ(clientScripts.load("program p {\n  host.slow.cmd(3)\n  got = 1\n}\n"), "");
    ASSERT_TRUE(clientScripts["p"].start());
    for (int step = 0; step != 2; ++step) {
        ASSERT_TRUE(client.update());
        EXPECT_EQ(got, 0);
        ASSERT_TRUE(host.update());
    }
    ASSERT_TRUE(client.update());
    EXPECT_EQ(got, 1) << clientScripts["p"].getError();
}

TEST_F(SentFunctions, OneStatementHasEightUnderWay) {
    const auto one = types_test::variable(1);
    const auto sending = part("add")->produceSend({one, one}, client.engine());
    for (int i = 0; i != 8; ++i) EXPECT_TRUE(sending->evaluate()) << i;
    EXPECT_FALSE(sending->evaluate());
    EXPECT_TRUE(
        log.contains("function 'add' of component 'host' is not sent: the last 8 calls are not done, or their handles "
                     "are still in use"))
        << log.text();
    const auto handle = part("add")->produceHandle();
    EXPECT_FALSE(handle->update(sending.get()));
    ASSERT_TRUE(host.update());
    EXPECT_EQ(count, 8);
    EXPECT_TRUE(handle->update(sending.get()));
    ASSERT_TRUE(host.update());
    EXPECT_EQ(count, 9);
}

TEST_F(SentFunctions, OutliveTheirHandlesAndTheirSender) {
    { OperationCaller<int(int, int)>(part("add"), client.engine()).send(1, 1); }
    { OperationCaller<int(int)>(part("slow"), client.engine()).send(1); }
    host.provides()->remove("slow");
    ASSERT_TRUE(host.update() && host.update() && host.update());
    EXPECT_EQ(count, 1);
}

TEST_F(SentFunctions, OnesThatNobodyWillExecuteFail) {
    OperationCaller<int(int)> slow(part("slow"), client.engine());
    auto queued = slow.send(1), begun = slow.send(2);
    int result = 0;
    host.fatal();
    EXPECT_EQ(queued.collect(result), SendFailure);
    EXPECT_EQ(begun.collect(result), SendFailure);
    EXPECT_FALSE(slow.send(1).ready());
    EXPECT_EQ(result, 0);
}

TEST_F(SentFunctions, WrongVariablesForTheResultAreRefused) {
    const OperationInterfacePart& add = *part("add");
    const auto handle = add.produceHandle();
    EXPECT_THROW(add.produceCollect({types_test::variable(1)}, nullptr), wrong_types_of_args_exception);
    EXPECT_THROW(add.produceCollect({handle, types_test::variable("text")}, nullptr), wrong_types_of_args_exception);
    EXPECT_THROW(add.produceCollect({handle, handle, handle}, nullptr), wrong_number_of_args_exception);
    EXPECT_THROW(add.produceCollect({handle, new internal::ConstantDataSource<int>(1)}, nullptr),
                 non_lvalue_args_exception);
    const auto collect = add.produceCollect({handle, types_test::variable(1)}, nullptr);
    EXPECT_EQ(types_test::valueOf<SendStatus>(collect), SendFailure) << "nothing was sent";
}

TEST_F(SentFunctions, HandlesOfAnotherFunctionAreRefusedByThoseThatWantTheResult) {
    const auto one = types_test::variable(1);
    const auto handle = part("slow")->produceHandle();
    const auto sending = part("slow")->produceSend({one}, client.engine());
    ASSERT_TRUE(handle->update(sending.get()));
    internal::DataSource<bool>::shared_ptr const poll(new internal::ConstantDataSource<bool>(false));
    const auto result = part("add")->produceCollect({handle, types_test::variable(1)}, poll);
    EXPECT_EQ(types_test::valueOf<SendStatus>(result), SendFailure);
    const auto status = part("add")->produceCollect({handle}, poll);
    EXPECT_NE(types_test::valueOf<SendStatus>(status), SendFailure) << "the status is known";
}

}  // namespace
