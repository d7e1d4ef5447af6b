// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The engine and the life cycle: triggering, steps, asking for the state, the queue.
#include <support/real_time_trap.hpp>

#include <rtt/Activity.hpp>
#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/engine/access_gate.hpp>
#include <rtt/internal/engine/mailbox.hpp>
#include <rtt/internal/engine/wait_point.hpp>

#include <atomic>
#include <chrono>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using namespace RTT;
using oroforge::test::expectRealTime;
using oroforge::test::RealTimeTrap;

namespace {

class RealTimeEngine : public testing::Test {
protected:
    void SetUp() override { OROFORGE_NEEDS_REAL_TIME_TRAP(); }
};

struct Counting : TaskContext {
    explicit Counting(const std::string& name) : TaskContext(name) {}
    ~Counting() override {
        stop();
        if (getActivity()) getActivity()->stop();
    }
    void updateHook() override { ++updates; }
    void errorHook() override { ++errors; }
    std::atomic<int> updates{0}, errors{0};
};

struct Message : base::DisposableInterface {
    void executeAndDispose() override { ++executed; }
    void dispose() override {}
    int executed = 0;
};

struct Function : base::ExecutableInterface {
    bool execute() override { return ++executions % 5 != 0; }
    int executions = 0;
};

}  // namespace

TEST_F(RealTimeEngine, AComponentIsTriggered) {
    Counting component("component");
    ASSERT_TRUE(component.start());
    expectRealTime([&] {
        for (int i = 0; i < 20; ++i) EXPECT_TRUE(component.trigger());
    });
    component.stop();
}

TEST_F(RealTimeEngine, AComponentIsAskedForItsState) {
    Counting component("component");
    ASSERT_TRUE(component.start());
    expectRealTime([&] {
        EXPECT_TRUE(component.isRunning() && component.isConfigured() && component.isActive());
        EXPECT_FALSE(component.inFatalError() || component.inException() || component.inRunTimeError());
        EXPECT_EQ(component.getTaskState(), base::TaskCore::Running);
        EXPECT_EQ(component.getTargetState(), base::TaskCore::Running);
        EXPECT_EQ(component.getPeriod(), 0);
        EXPECT_FALSE(component.engine()->isSelf() || component.engine()->isStepping());
        EXPECT_EQ(component.engine()->getTaskCore(), &component);
        EXPECT_EQ(component.getName().size(), 9u);
        EXPECT_NE(component.getActivity(), nullptr);
        EXPECT_NE(component.provides(), nullptr);
    });
    component.stop();
}

TEST_F(RealTimeEngine, StepsAreMade) {
    Counting component("component");
    ASSERT_TRUE(component.setActivity(new extras::SlaveActivity()));
    ASSERT_TRUE(component.start());
    ASSERT_TRUE(component.update());
    expectRealTime([&] {
        for (int i = 0; i < 10; ++i) EXPECT_TRUE(component.update());
        component.error();
        EXPECT_TRUE(component.update());
        EXPECT_TRUE(component.recover());
    });
    EXPECT_EQ(component.updates, 11);
    EXPECT_GE(component.errors, 1);
    component.stop();
}

// With hooks that are: none of these functions has anything to allocate itself.
TEST_F(RealTimeEngine, AComponentIsStartedAndStopped) {
    Counting component("component");
    ASSERT_TRUE(component.setActivity(new extras::SlaveActivity()));
    ASSERT_TRUE(component.start() && component.stop());
    expectRealTime(
        [&] {
            EXPECT_TRUE(component.start());
            EXPECT_TRUE(component.stop());
        },
        RealTimeTrap::kAllocation | RealTimeTrap::kRelease);
}

TEST_F(RealTimeEngine, MessagesAndFunctionsAreQueuedAndExecuted) {
    Counting component("component");
    ASSERT_TRUE(component.setActivity(new extras::SlaveActivity()));
    ASSERT_TRUE(component.start());
    Message message;
    Function function;
    ASSERT_TRUE(component.engine()->process(&message));
    ASSERT_TRUE(component.engine()->runFunction(&function));
    for (int i = 0; i < 6; ++i) component.update();
    expectRealTime([&] {
        for (int i = 0; i < 10; ++i) EXPECT_TRUE(component.engine()->process(&message));
        EXPECT_TRUE(component.engine()->hasWork());
        EXPECT_TRUE(component.update());
        EXPECT_TRUE(ExecutionEngine::process(*component.engine()->gate(), &message));
        EXPECT_TRUE(component.engine()->runFunction(&function));
        for (int i = 0; i < 10; ++i) EXPECT_TRUE(component.update());
    });
    EXPECT_EQ(message.executed, 12);
    EXPECT_EQ(function.executions, 10);
    component.stop();
}

// The component's own thread, from inside its steps.
TEST_F(RealTimeEngine, ASteppingThreadDoesNothingBetweenItsHooks) {
    struct Watching : TaskContext {
        Watching() : TaskContext("watching") { setActivity(new Activity(ORO_SCHED_OTHER, 0, 0.001, nullptr, "w")); }
        ~Watching() override { stop(), getActivity()->stop(); }
        void updateHook() override {
            // From one updateHook() to the next.
            trap.reset();
            if (++updates < 20) trap = std::make_unique<RealTimeTrap>(kinds);
        }
        // Sleeping until the next period is what it is there for.
        const unsigned kinds = RealTimeTrap::kAllocation | RealTimeTrap::kRelease | RealTimeTrap::kLock;
        std::unique_ptr<RealTimeTrap> trap;
        std::atomic<int> updates{0};
    };
    Watching component;
    ASSERT_TRUE(component.start());
    for (int i = 0; i < 10000 && component.updates < 20; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_GE(component.updates, 20);
    component.stop();
}

TEST_F(RealTimeEngine, TheMailboxTakesAndGives) {
    internal::Mailbox box;
    int what = 0;
    expectRealTime([&] {
        internal::Mailbox::Item item{internal::Mailbox::Kind::Message, &what};
        for (unsigned i = 0; i < internal::Mailbox::kCapacity; ++i) EXPECT_TRUE(box.put(item));
        EXPECT_FALSE(box.put(item));
        while (box.take(item)) {
        }
        EXPECT_TRUE(box.empty());
    });
}

TEST_F(RealTimeEngine, WaitersAreNotified) {
    internal::WaitPoint point;
    std::atomic<bool> woken{false};
    std::thread waiter([&] {
        point.wait(point.ticket());
        woken = true;
    });
    while (!woken) expectRealTime([&] { point.notify(); });
    waiter.join();
}

TEST_F(RealTimeEngine, GatesAreEntered) {
    const auto gate = std::make_shared<internal::AccessGate>();
    gate->share();
    gate->open();
    expectRealTime([&] {
        internal::AccessGate::Pass outer(gate);
        EXPECT_TRUE(outer);
    });
}

TEST_F(RealTimeEngine, ManyCallbacksComeUpDuringAWait) {
    Counting component("component");
    ASSERT_TRUE(component.setActivity(new extras::SlaveActivity));
    std::vector<std::unique_ptr<InputPort<int>>> ports;
    OutputPort<int> out("out");
    int calls = 0;
    for (int i = 0; i != 40; ++i) {
        ports.emplace_back(new InputPort<int>("port" + std::to_string(i)));
        component.addEventPort(*ports.back(), [&calls](base::PortInterface*) { ++calls; });
        ASSERT_TRUE(out.createConnection(*ports.back()));
    }
    ASSERT_TRUE(component.start());
    Message message;
    struct Waiting : base::DisposableInterface {
        void executeAndDispose() override {
            expectRealTime([&] {
                out->write(1);
                EXPECT_TRUE(engine->process(message));
                engine->waitForMessages([this] { return message->executed == 1; });
            });
        }
        void dispose() override {}
        OutputPort<int>* out;
        ExecutionEngine* engine;
        Message* message;
    } waiting;
    waiting.out = &out;
    waiting.engine = component.engine();
    waiting.message = &message;
    ASSERT_TRUE(component.engine()->process(&waiting));
    component.update();
    component.update();
    EXPECT_EQ(calls, 40);
    component.stop();
}
