// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Steps of programs, and calls of functions, allocate nothing and take no lock.
#include "script_bench.hpp"

#include <rtt/internal/GlobalEngine.hpp>
#include <support/real_time_trap.hpp>
#include <unit/operations/probe.hpp>
#include <unit/types/builtin_typekit.hpp>

using namespace RTT;
using oroforge::test::expectRealTime;
using oroforge::test::Probe;
using oroforge::test::RealTimeTrap;
using script_test::ScriptBench;

namespace {

struct RealTimePrograms : types_test::WithBuiltinTypes {
    void SetUp() override {
        OROFORGE_NEEDS_REAL_TIME_TRAP();
        ASSERT_TRUE(host.setActivity(new extras::SlaveActivity(0.01)));
        host.addAttribute("count", count);
        host.addOperation("twice", [](int value) { return 2 * value; });
        ASSERT_EQ(
            scripts.load("export int half(int value) {\n  return value / 2\n}\n"
                         "export int slow(int value) {\n  yield\n  return value\n}\n"
                         "program p {\n  var double x = 1.5\n  var int i = 0\n  for (i = 0; i < 20; i = i + 1) {\n"
                         "    if x > 100.0 then x = 1.0 else x = x * 1.25 + i\n    count = twice(half(i))\n"
                         "    try twice(i)\n    yield\n  }\n}\n"),
            "");
    }
    int count = 0;
    Probe host{"host"};
    ScriptBench scripts{host};
};

TEST_F(RealTimePrograms, AreStepped) {
    ASSERT_TRUE(scripts["p"].start());
    ASSERT_TRUE(host.update());
    expectRealTime([&] {
        for (int i = 0; i != 30; ++i) EXPECT_TRUE(host.update());
    });
    EXPECT_TRUE(scripts["p"].isStopped()) << scripts["p"].getError();
    EXPECT_EQ(count, 18);
}

TEST_F(RealTimePrograms, AreCommandedAndAskedForTheirState) {
    scripting::ProgramInterface& p = scripts["p"];
    ASSERT_TRUE(p.start() && host.update() && p.stop());
    expectRealTime([&] {
        EXPECT_TRUE(p.pause());
        EXPECT_TRUE(host.update());
        EXPECT_TRUE(p.isPaused() && p.step());
        EXPECT_TRUE(host.update());
        EXPECT_TRUE(p.start());
        EXPECT_TRUE(host.update());
        EXPECT_TRUE(p.isRunning());
        EXPECT_NE(p.getLineNumber(), 0);
        EXPECT_TRUE(p.stop());
    });
}

TEST_F(RealTimePrograms, AreStartedAnewAfterTheyHadNothingToDo) {
    scripting::ProgramInterface& p = scripts["p"];
    ASSERT_TRUE(host.update() && host.update());
    expectRealTime([&] {
        for (int round = 0; round != 3; ++round) {
            EXPECT_TRUE(p.start());
            for (int i = 0; i != 30; ++i) EXPECT_TRUE(host.update());
            EXPECT_TRUE(p.isStopped());
        }
    });
}

TEST_F(RealTimePrograms, FunctionsAreCalledInPlace) {
    const auto value = types_test::variable(8);
    auto* const half = internal::DataSource<int>::narrow(
        base::DataSourceBase::shared_ptr(host.getOperation("half")->produce({value}, host.engine())).detach());
    ASSERT_NE(half, nullptr);
    host.onUpdate = [&] {
        expectRealTime([&] {
            for (int i = 0; i != 10; ++i) EXPECT_EQ(half->get(), 4);
        });
    };
    ASSERT_TRUE(host.start() && host.update());
    half->deref();
}

TEST_F(RealTimePrograms, FunctionsAreSentAndCollected) {
    const auto value = types_test::variable(8), result = types_test::variable(0);
    OperationInterfacePart& slow = *host.getOperation("slow");
    const auto handle = slow.produceHandle();
    const auto sending = slow.produceSend({value}, internal::GlobalEngine::Instance());
    const auto collecting = slow.produceCollect({handle, result}, new internal::ConstantDataSource<bool>(false));
    for (int round = 0; round != 3; ++round) {
        result->set(0);
        expectRealTime([&] {
            EXPECT_TRUE(handle->update(sending.get()));
            EXPECT_TRUE(collecting->evaluate());
            EXPECT_TRUE(host.update() && host.update());
            EXPECT_TRUE(collecting->evaluate());
        });
        EXPECT_EQ(result->get(), 8);
    }
}

// Each thread watches itself.
TEST_F(RealTimePrograms, FunctionsAreCalledFromOtherThreads) {
    Probe server("server");
    ScriptBench serverScripts(server);
    ASSERT_EQ(serverScripts.load("export int add(int a, int b) {\n  return a + b\n}"), "");
    const auto a = types_test::variable(3), b = types_test::variable(4);
    const base::DataSourceBase::shared_ptr call =
        server.getOperation("add")->produce({a, b}, internal::GlobalEngine::Instance());
    ASSERT_TRUE(call->evaluate());
    expectRealTime(
        [&] {
            for (int i = 0; i != 10; ++i) EXPECT_TRUE(call->evaluate());
        },
        RealTimeTrap::kAllocation | RealTimeTrap::kRelease | RealTimeTrap::kLock);
    EXPECT_EQ(types_test::valueOf<int>(call), 7);
}

}  // namespace
