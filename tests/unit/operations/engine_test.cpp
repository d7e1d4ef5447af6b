// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a step consists of, in which order, and what leads to one.
#include "probe.hpp"

#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/extras/SlaveActivity.hpp>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::makeManual;
using oroforge::test::Note;
using oroforge::test::Probe;
using oroforge::test::Steps;

namespace {

TEST(EngineStep, MessagesThenFunctionsThenUpdateHook) {
    Probe probe;
    makeManual(probe);
    probe.onUpdate = [&] { probe.note("update"); };
    ASSERT_TRUE(probe.start());
    probe.takeHooks();
    Steps function([&] { return probe.note("function"), false; });
    Note message([&] { probe.note("message"); });
    ASSERT_TRUE(probe.engine()->runFunction(&function));
    ASSERT_TRUE(probe.engine()->process(&message));
    EXPECT_TRUE(probe.engine()->hasWork());

    ASSERT_TRUE(probe.update());

    EXPECT_EQ(probe.takeHooks(), "message function update");
    EXPECT_FALSE(probe.engine()->hasWork());
    EXPECT_FALSE(function.isLoaded());
}

TEST(EngineStep, MessagesThatMessagesSendAreExecutedInTheSameStep) {
    Probe probe;
    makeManual(probe);
    Note second([&] { probe.note("second"); });
    Note first([&] { probe.note("first"), probe.engine()->process(&second); });
    ASSERT_TRUE(probe.engine()->process(&first));
    ASSERT_TRUE(probe.update());
    EXPECT_EQ(probe.takeHooks(), "first second");
}

TEST(EngineStep, TriggerExecutesMessagesOnly) {
    Probe probe;
    makeManual(probe);
    ASSERT_TRUE(probe.start());
    Steps function([] { return true; });
    ASSERT_TRUE(probe.engine()->runFunction(&function));
    Note message;
    ASSERT_TRUE(probe.engine()->process(&message));
    probe.engine()->work(base::RunnableInterface::Trigger);
    EXPECT_EQ(message.executed, 1);
    EXPECT_EQ(function.executions, 0);
    EXPECT_EQ(probe.updates, 0);
    probe.engine()->work(base::RunnableInterface::IOReady);
    EXPECT_EQ(function.executions, 1);
    EXPECT_EQ(probe.updates, 1);
    EXPECT_TRUE(probe.engine()->removeFunction(&function));
}

TEST(EngineStep, CountsStepsByTheirReason) {
    Probe probe;
    makeManual(probe);
    const auto counter = [&](const char* name) {
        auto* attribute = Attribute<unsigned>::narrow(probe.getAttribute(name));
        return attribute ? attribute->get() : ~0u;
    };
    const unsigned cycles = counter("CycleCounter"), timeouts = counter("TimeOutCounter"),
                   triggers = counter("TriggerCounter"), ios = counter("IOCounter");
    probe.engine()->work(base::RunnableInterface::TimeOut);
    probe.engine()->work(base::RunnableInterface::Trigger);
    probe.engine()->work(base::RunnableInterface::Trigger);
    probe.engine()->work(base::RunnableInterface::IOReady);
    EXPECT_EQ(counter("CycleCounter"), cycles + 4);
    EXPECT_EQ(counter("TimeOutCounter"), timeouts + 1);
    EXPECT_EQ(counter("TriggerCounter"), triggers + 2);
    EXPECT_EQ(counter("IOCounter"), ios + 1);
}

TEST(EngineRefuses, NullAndWhatComesInFatalError) {
    Probe probe;
    EXPECT_FALSE(probe.engine()->process(static_cast<base::DisposableInterface*>(nullptr)));
    EXPECT_FALSE(probe.engine()->runFunction(nullptr));
    probe.fatal();
    Note message;
    Steps function([] { return false; });
    EXPECT_FALSE(probe.engine()->process(&message));
    EXPECT_FALSE(probe.engine()->runFunction(&function));
    EXPECT_FALSE(function.isLoaded());
}

TEST(EngineRefuses, WhatNoActivityWouldExecute) {
    ExecutionEngine engine;
    Note message;
    EXPECT_FALSE(engine.process(&message));
}

TEST(EngineDestruction, DisposesOfWhatIsStillQueued) {
    Note message;
    {
        Probe probe;
        makeManual(probe);
        ASSERT_TRUE(probe.engine()->process(&message));
    }
    EXPECT_EQ(message.executed, 0);
    EXPECT_EQ(message.disposed, 1);
}

TEST(EngineFatal, DisposesOfWhatIsStillQueued) {
    Probe probe;
    makeManual(probe);
    Note message;
    ASSERT_TRUE(probe.engine()->process(&message));
    probe.fatal();
    EXPECT_EQ(message.disposed, 1);
}

TEST(EngineIdentity, IsSelfOnlyInTheThreadOfTheActivity) {
    Probe probe;
    EXPECT_FALSE(probe.engine()->isSelf());
    std::atomic<int> self{-1};
    Note message([&] { self = probe.engine()->isSelf(); });
    ASSERT_TRUE(probe.engine()->process(&message));
    ASSERT_TRUE(eventually([&] { return message.executed == 1; }));
    EXPECT_EQ(self, 1);
}

// --- what leads to updateHook() ---

TEST(Triggering, StartTriggersOneUpdateUnlessTriggerOnStartIsOff) {
    Probe probe;
    ASSERT_TRUE(probe.start());
    EXPECT_TRUE(eventually([&] { return probe.updates == 1; }));
    ASSERT_TRUE(probe.stop());
    Attribute<bool>(probe.getAttribute("TriggerOnStart")).set(false);
    ASSERT_TRUE(probe.start());
    usleep(20000);
    EXPECT_EQ(probe.updates, 1);
}

TEST(Triggering, TriggerUpdatesOnlyComponentsThatAreNotPeriodic) {
    Probe probe;
    ASSERT_TRUE(probe.start());
    ASSERT_TRUE(eventually([&] { return probe.updates == 1; }));
    EXPECT_TRUE(probe.trigger());
    EXPECT_TRUE(eventually([&] { return probe.updates == 2; }));
    ASSERT_TRUE(probe.setPeriod(100.0));
    EXPECT_FALSE(probe.trigger());
}

TEST(Triggering, PeriodUpdates) {
    Probe probe;
    ASSERT_TRUE(probe.setPeriod(0.002));
    EXPECT_EQ(probe.getPeriod(), 0.002);
    ASSERT_TRUE(probe.start());
    EXPECT_TRUE(eventually([&] { return probe.updates > 5; }));
}

TEST(Triggering, SentOperationIsExecutedBetweenPeriodsWithoutUpdate) {
    Probe probe;
    ASSERT_TRUE(probe.setPeriod(100.0));
    ASSERT_TRUE(probe.start());
    std::atomic<int> executed{0};
    probe.addOperation(
        "op", [&] { ++executed; }, OwnThread);
    OperationCaller<void()> op = probe.getOperation("op");
    op.send();
    EXPECT_TRUE(eventually([&] { return executed == 1; }));
    EXPECT_EQ(probe.updates, 0);
}

struct Eventful : testing::Test {
    Probe probe{"reader"};
    InputPort<int> in{"in"};
    OutputPort<int> out{"out"};
    ~Eventful() override { probe.ports()->removePort("in"); }
};

TEST_F(Eventful, NewDataWithoutCallbackUpdates) {
    probe.addEventPort(in);
    ASSERT_TRUE(out.connectTo(&in));
    ASSERT_TRUE(probe.start());
    ASSERT_TRUE(eventually([&] { return probe.updates == 1; }));
    out.write(1);
    EXPECT_TRUE(eventually([&] { return probe.updates == 2; }));
}

TEST_F(Eventful, NewDataWithCallbackCallsItInTheOwnThreadAndDoesNotUpdate) {
    std::atomic<int> calls{0};
    std::atomic<bool> own{false};
    std::atomic<base::PortInterface*> port{nullptr};
    probe.addEventPort(in, [&](base::PortInterface* which) {
        port = which;
        own = probe.engine()->isSelf();
        ++calls;
    });
    ASSERT_TRUE(out.connectTo(&in));
    ASSERT_TRUE(probe.start());
    ASSERT_TRUE(eventually([&] { return probe.updates == 1; }));
    out.write(1);
    ASSERT_TRUE(eventually([&] { return calls == 1; }));
    EXPECT_TRUE(own);
    EXPECT_EQ(port, &in);
    usleep(5000);
    EXPECT_EQ(probe.updates, 1);
}

TEST_F(Eventful, NewDataWhileNotRunningIsNotAnnouncedButKept) {
    std::atomic<int> calls{0};
    probe.addEventPort(in, [&](base::PortInterface*) { ++calls; });
    ASSERT_TRUE(out.connectTo(&in));
    out.write(7);
    ASSERT_TRUE(probe.start());
    usleep(10000);
    EXPECT_EQ(calls, 0);
    int value = 0;
    EXPECT_EQ(in.read(value), NewData);
    EXPECT_EQ(value, 7);
}

TEST_F(Eventful, PortIsQueuedAtMostOnce) {
    int calls = 0;
    makeManual(probe);
    probe.addEventPort(in, [&](base::PortInterface*) { ++calls; });
    ASSERT_TRUE(out.connectTo(&in));
    ASSERT_TRUE(probe.start());
    for (int i = 0; i != 500; ++i) out.write(i);
    ASSERT_TRUE(probe.update());
    EXPECT_EQ(calls, 1);
    out.write(1);
    ASSERT_TRUE(probe.update());
    EXPECT_EQ(calls, 2);
}

TEST_F(Eventful, CallbackThatThrowsLeadsToException) {
    probe.addEventPort(in, [](base::PortInterface*) { throw 42; });
    ASSERT_TRUE(out.connectTo(&in));
    ASSERT_TRUE(probe.start());
    out.write(1);
    EXPECT_TRUE(eventually([&] { return probe.inException(); }));
    EXPECT_TRUE(probe.isActive());
}

// A component in the middle of its updateHook() does not expect its port callbacks because it calls another component.
TEST_F(Eventful, CallbackIsNotCalledWhileTheComponentWaitsForAnOperation) {
    Probe server("server");
    server.addOperation(
        "slow",
        [&] {
            out.write(1);
            usleep(5000);
        },
        OwnThread);
    OperationCaller<void()> slow(server.getOperation("slow"), probe.engine());
    std::atomic<bool> waiting{false}, nested{false};
    std::atomic<int> calls{0};
    probe.addEventPort(in, [&](base::PortInterface*) {
        nested = waiting.load();
        ++calls;
    });
    ASSERT_TRUE(out.connectTo(&in));
    probe.onUpdate = [&] {
        waiting = true;
        slow();
        waiting = false;
    };
    ASSERT_TRUE(probe.start());
    ASSERT_TRUE(eventually([&] { return calls == 1; }));
    EXPECT_FALSE(nested);
}

}  // namespace
