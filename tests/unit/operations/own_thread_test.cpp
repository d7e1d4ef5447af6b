// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Operations that the component's own thread executes: call, send, collect.
#include "probe.hpp"

#include <rtt/Activity.hpp>
#include <rtt/SendHandle.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <stdexcept>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;

namespace {

struct OwnThreadCall : testing::Test {
    Probe server{"server"}, client{"client"};
    ExecutionEngine* global = internal::GlobalEngine::Instance();

    /** Runs `action` in the client's thread and waits for it. */
    void inClient(std::function<void()> action) {
        std::atomic<bool> done{false};
        client.onUpdate = [&] {
            action();
            done = true;
        };
        ASSERT_TRUE(client.start());
        ASSERT_TRUE(eventually([&] { return done.load(); }));
        client.onUpdate = nullptr;
        ASSERT_TRUE(client.stop());
    }
};

TEST_F(OwnThreadCall, IsExecutedByTheThreadOfTheComponent) {
    server.addOperation(
        "is_self", [this] { return server.engine()->isSelf(); }, OwnThread);
    OperationCaller<bool()> op(server.getOperation("is_self"), global);
    EXPECT_TRUE(op());
    bool answer = false;
    inClient([&] {
        op.setCaller(client.engine());
        answer = op();
    });
    EXPECT_TRUE(answer);
}

TEST_F(OwnThreadCall, FromTheOwnThreadIsDirect) {
    server.addOperation(
        "inner", [] { return std::this_thread::get_id(); }, OwnThread);
    OperationCaller<std::thread::id()> inner(server.getOperation("inner"), server.engine());
    server.addOperation(
        "outer", [&] { return inner() == std::this_thread::get_id(); }, OwnThread);
    OperationCaller<bool()> outer(server.getOperation("outer"), global);
    EXPECT_TRUE(outer());
}

TEST_F(OwnThreadCall, WorksWhateverTheStateOfTheComponent) {
    Probe raw("raw", TaskContext::PreOperational);
    raw.addOperation(
        "op", [] { return 5; }, OwnThread);
    OperationCaller<int()> op(raw.getOperation("op"), global);
    EXPECT_EQ(op(), 5);
    raw.configure();
    EXPECT_EQ(op(), 5);
    raw.exception();
    EXPECT_EQ(op(), 5);
}

TEST_F(OwnThreadCall, ArgumentsByReferenceAreWrittenBack) {
    server.addOperation(
        "divide", [](int a, int b, int& rest) { return rest = a % b, a / b; }, OwnThread);
    OperationCaller<int(int, int, int&)> divide(server.getOperation("divide"), global);
    int rest = 0;
    EXPECT_EQ(divide(17, 5, rest), 3);
    EXPECT_EQ(rest, 2);
}

TEST_F(OwnThreadCall, ExceptionPutsTheServerIntoExceptionAndReachesTheCallerAsRuntimeError) {
    ASSERT_TRUE(server.start());
    server.addOperation(
        "bad", []() -> int { throw std::logic_error("planted"); }, OwnThread);
    OperationCaller<int()> bad(server.getOperation("bad"), global);
    EXPECT_THROW(bad(), std::runtime_error);
    EXPECT_TRUE(server.inException());
    EXPECT_TRUE(server.isActive());
}

TEST_F(OwnThreadCall, WithoutCallerThrows) {
    server.addOperation(
        "op", [] {}, OwnThread);
    OperationCaller<void()> op = server.getOperation("op");
    try {
        op();
        FAIL();
    } catch (const SendError& error) {
        EXPECT_EQ(error.status(), CollectFailure);
    }
}

TEST_F(OwnThreadCall, ToAComponentInFatalErrorThrows) {
    server.addOperation(
        "op", [] {}, OwnThread);
    OperationCaller<void()> op(server.getOperation("op"), global);
    server.fatal();
    try {
        op();
        FAIL();
    } catch (const std::exception& error) {
        const auto* send = dynamic_cast<const SendError*>(&error);
        ASSERT_TRUE(send);
        EXPECT_EQ(send->status(), SendFailure);
    }
}

TEST_F(OwnThreadCall, WaitingWhenTheComponentFailsForGoodThrows) {
    std::atomic<bool> entered{false};
    server.addOperation(
        "op", [] {}, OwnThread);
    server.addOperation(
        "doom",
        [&] {
            entered = true;
            usleep(20000);
            server.fatal();
        },
        OwnThread);
    OperationCaller<void()> op(server.getOperation("op"), global), doom(server.getOperation("doom"), global);
    doom.send();
    ASSERT_TRUE(eventually([&] { return entered.load(); }));
    EXPECT_THROW(op(), SendError);
}

TEST_F(OwnThreadCall, BothDirectionsNested) {
    // client.ping -> server.pong(n) -> client.ping(n - 1) …: each thread answers while it waits.
    OperationCaller<int(int)> ping, pong;
    client.addOperation(
        "ping", [&](int n) { return n == 0 ? 0 : 1 + pong(n - 1); }, OwnThread);
    server.addOperation(
        "pong", [&](int n) { return n == 0 ? 0 : 1 + ping(n - 1); }, OwnThread);
    ping = OperationCaller<int(int)>(client.getOperation("ping"), server.engine());
    pong = OperationCaller<int(int)>(server.getOperation("pong"), client.engine());
    OperationCaller<int(int)> start(client.getOperation("ping"), global);
    EXPECT_EQ(start(20), 20);
}

TEST_F(OwnThreadCall, ChangingTheThreadAffectsNewCallers) {
    server.addOperation(
        "op", [this] { return server.engine()->isSelf(); }, OwnThread);
    ASSERT_TRUE(server.provides()->setOperationThread("op", ClientThread));
    OperationCaller<bool()> op(server.getOperation("op"), global);
    EXPECT_FALSE(op());
    EXPECT_FALSE(server.provides()->setOperationThread("missing", ClientThread));
}

TEST_F(OwnThreadCall, OfASubService) {
    server.provides("sub")->addOperation(
        "op", [this] { return server.engine()->isSelf(); }, OwnThread);
    OperationCaller<bool()> op(server.provides("sub")->getOperation("op"), global);
    EXPECT_TRUE(op());
}

TEST_F(OwnThreadCall, OfAServiceAddedAfterItGotItsOperations) {
    Service::shared_ptr service(new Service("late"));
    service->addOperation(
        "op", [this] { return server.engine()->isSelf(); }, OwnThread);
    ASSERT_TRUE(server.provides()->addService(service));
    OperationCaller<bool()> op(service->getOperation("op"), global);
    EXPECT_TRUE(op());
}

TEST_F(OwnThreadCall, OnASlaveIsExecutedByItsMaster) {
    Probe slave("slave");
    ASSERT_TRUE(slave.setActivity(new extras::SlaveActivity(server.getActivity())));
    slave.addOperation(
        "who", [this] { return server.engine()->isSelf(); }, OwnThread);
    OperationCaller<bool()> who(slave.getOperation("who"), global);
    EXPECT_TRUE(who());
    slave.getActivity()->stop();
}

struct Send : OwnThreadCall {};

TEST_F(Send, CollectGivesResultAndReferences) {
    server.addOperation(
        "divide", [](int a, int b, int& rest) { return rest = a % b, a / b; }, OwnThread);
    OperationCaller<int(int, int, int&)> divide(server.getOperation("divide"), global);
    int unused = 0, result = 0, rest = 0;
    SendHandle<int(int, int, int&)> handle = divide.send(17, 5, unused);
    EXPECT_TRUE(handle.ready());
    EXPECT_EQ(handle.collect(result, rest), SendSuccess);
    EXPECT_EQ(result, 3);
    EXPECT_EQ(rest, 2);
    EXPECT_EQ(handle.collect(), SendSuccess) << "again, without values";
    EXPECT_EQ(handle.ret(), 3);
    EXPECT_EQ(unused, 0) << "send() takes copies";
}

TEST_F(Send, CollectIfDoneDoesNotWait) {
    std::atomic<bool> go{false};
    server.addOperation(
        "wait",
        [&] {
            while (!go) usleep(100);
            return 1;
        },
        OwnThread);
    OperationCaller<int()> wait(server.getOperation("wait"), global);
    auto handle = wait.send();
    int result = 0;
    EXPECT_EQ(handle.collectIfDone(result), SendNotReady);
    EXPECT_EQ(result, 0);
    go = true;
    EXPECT_TRUE(eventually([&] { return handle.collectIfDone(result) == SendSuccess; }));
    EXPECT_EQ(result, 1);
}

TEST_F(Send, ManyAreExecutedInOrder) {
    std::vector<int> order;
    server.addOperation(
        "note", [&](int n) { order.push_back(n); }, OwnThread);
    OperationCaller<void(int)> note(server.getOperation("note"), global);
    std::vector<SendHandle<void(int)>> handles;
    for (int i = 0; i != 16; ++i) handles.push_back(note.send(i));
    for (auto& handle : handles) EXPECT_EQ(handle.collect(), SendSuccess);
    for (int i = 0; i != 16; ++i) EXPECT_EQ(order[i], i);
}

TEST_F(Send, WithoutHandleIsExecutedAllTheSame) {
    std::atomic<int> executed{0};
    server.addOperation(
        "op", [&] { ++executed; }, OwnThread);
    OperationCaller<void()> op(server.getOperation("op"), global);
    op.send();
    EXPECT_TRUE(eventually([&] { return executed == 1; }));
}

TEST_F(Send, OfAClientThreadOperationIsExecutedByTheGlobalEngine) {
    server.addOperation("self", [this] { return global->isSelf(); });
    OperationCaller<bool()> self(server.getOperation("self"), client.engine());
    bool answer = false;
    EXPECT_EQ(self.send().collect(answer), SendSuccess);
    EXPECT_TRUE(answer);
}

TEST_F(Send, CollectingAnOperationThatThrewThrows) {
    server.addOperation(
        "bad", []() -> int { throw 42; }, OwnThread);
    OperationCaller<int()> bad(server.getOperation("bad"), global);
    auto handle = bad.send();
    EXPECT_THROW(handle.collect(), std::runtime_error);
    int result = 0;
    EXPECT_THROW(handle.collectIfDone(result), std::runtime_error);
    EXPECT_THROW(handle.ret(), std::runtime_error);
}

TEST_F(Send, UnboundOrRefusedFails) {
    OperationCaller<int()> unbound;
    EXPECT_EQ(unbound.send().collect(), SendFailure);
    EXPECT_FALSE(unbound.send().ready());
    server.addOperation(
        "op", [] { return 1; }, OwnThread);
    OperationCaller<int()> op(server.getOperation("op"), global);
    server.fatal();
    EXPECT_EQ(op.send().collect(), SendFailure);
}

TEST_F(Send, WhatDoesNotFitIntoTheQueueFailsAndTheRestIsExecuted) {
    ASSERT_TRUE(server.setActivity(new extras::SlaveActivity()));
    int executed = 0;
    server.addOperation(
        "op", [&] { ++executed; }, OwnThread);
    OperationCaller<void()> op(server.getOperation("op"), global);
    std::vector<SendHandle<void()>> handles;
    for (std::size_t i = 0; i != internal::Mailbox::kCapacity; ++i) handles.push_back(op.send());
    EXPECT_FALSE(op.send().ready());
    ASSERT_TRUE(server.update());
    EXPECT_EQ(executed, int(internal::Mailbox::kCapacity));
    for (auto& handle : handles) EXPECT_EQ(handle.collectIfDone(), SendSuccess);
}

TEST_F(Send, CollectWithoutCallerFailsUnlessItIsDone) {
    ASSERT_TRUE(server.setActivity(new extras::SlaveActivity()));
    server.addOperation(
        "op", [] { return 1; }, OwnThread);
    OperationCaller<int()> op = server.getOperation("op");
    auto handle = op.send();
    EXPECT_EQ(handle.collect(), CollectFailure);
    ASSERT_TRUE(server.update());
    EXPECT_EQ(handle.collect(), SendSuccess);
}

TEST_F(Send, HandleOutlivesTheComponent) {
    SendHandle<int()> handle;
    {
        Probe gone("gone");
        ASSERT_TRUE(gone.setActivity(new extras::SlaveActivity()));
        gone.addOperation(
            "op", [] { return 1; }, OwnThread);
        handle = OperationCaller<int()>(gone.getOperation("op"), global).send();
        EXPECT_EQ(handle.collectIfDone(), SendNotReady);
    }
    EXPECT_EQ(handle.collect(), SendFailure);
}

}  // namespace
