// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Sub-classes of activities and threads that have no runner: what they override is executed.
#include "file_descriptor_test.hpp"

#include <rtt/extras/Activities.hpp>

using namespace RTT;
using oroforge::test::eventually;

namespace {

struct Counts {
    std::atomic<int> initialized{0}, steps{0}, loops{0}, finalized{0};
};

/** Has a step() and no loop(). */
template <class Kind>
struct Stepping : Kind, Counts {
    using Kind::Kind;
    ~Stepping() override { this->stop(); }
    bool initialize() override { return ++initialized != 0; }
    void step() override { ++steps; }
    void finalize() override { ++finalized; }
};

/** Has a loop() and no step(). */
template <class Kind>
struct Looping : Kind, Counts {
    using Kind::Kind;
    ~Looping() override { this->stop(); }
    void loop() override { ++loops; }
};

class WithoutRunner : public testing::TestWithParam<int> {};

TEST_P(WithoutRunner, StepIsExecutedByStartTriggerTimeoutAndRestart) {
    Stepping<Activity> a(ORO_SCHED_OTHER, 0, 0.0);
    a.setWaitPeriodPolicy(GetParam());
    const auto steps = [&](int n) { return eventually([&] { return a.steps == n; }); };
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(steps(1));
    EXPECT_TRUE(a.trigger());
    EXPECT_TRUE(steps(2));
    EXPECT_TRUE(a.timeout());
    EXPECT_TRUE(steps(3));
    EXPECT_TRUE(a.start());  // once more, because it is active
    EXPECT_TRUE(steps(4));
    EXPECT_TRUE(a.stop());
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(steps(5));
    EXPECT_TRUE(a.stop());
    EXPECT_EQ(a.initialized, 2);
    EXPECT_EQ(a.finalized, 2);
}

TEST_P(WithoutRunner, StepIsExecutedOncePerPeriodThatIsSetLater) {
    Stepping<Activity> a(ORO_SCHED_OTHER, 0, 0.0);
    a.setWaitPeriodPolicy(GetParam());
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(a.setPeriod(0.001));
    EXPECT_TRUE(eventually([&] { return a.steps >= 5; }));
    ASSERT_TRUE(a.setPeriod(0.0));
    EXPECT_TRUE(eventually([&] { return a.stop(); }));
    const int steps = a.steps;
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return a.steps == steps + 1; }));
}
INSTANTIATE_TEST_SUITE_P(WaitPolicy, WithoutRunner, testing::Values(ORO_WAIT_ABS, ORO_WAIT_REL));

TEST(WithoutRunner, LoopIsExecutedByStartTriggerAndRestart) {
    Looping<Activity> a(ORO_SCHED_OTHER, 0, 0.0);
    const auto loops = [&](int n) { return eventually([&] { return a.loops == n; }); };
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(loops(1));
    EXPECT_TRUE(a.trigger());
    EXPECT_TRUE(loops(2));
    EXPECT_TRUE(a.timeout());  // that is for a step()
    EXPECT_TRUE(eventually([&] { return a.stop(); }));
    EXPECT_EQ(a.loops, 2);
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(loops(3));
}

TEST(WithoutRunner, StepOfAThreadIsExecutedByEachStart) {
    struct Thread : os::Thread {
        using os::Thread::Thread;
        ~Thread() override { terminate(); }
        bool initialize() override { return true; }
        void step() override {}
        void finalize() override {}
    };
    Stepping<Thread> t(ORO_SCHED_OTHER, 0, 0.0, 0, "stepping");
    for (int n = 1; n <= 3; ++n) {
        ASSERT_TRUE(t.start());
        EXPECT_TRUE(eventually([&] { return t.steps == n; }));
    }
    EXPECT_TRUE(t.stop());
    ASSERT_TRUE(t.start());
    EXPECT_TRUE(eventually([&] { return t.steps == 4; }));
}

TEST(WithoutRunner, StepIsThatOfAPeriodicActivity) {
    Stepping<extras::PeriodicActivity> a(ORO_SCHED_OTHER, 0, 0.002);
    for (int round = 1; round <= 2; ++round) {
        const int before = a.steps;
        ASSERT_TRUE(a.start());
        EXPECT_TRUE(eventually([&] { return a.steps >= before + 2; }));
        EXPECT_TRUE(a.stop());
        EXPECT_EQ(a.initialized, round);
        EXPECT_EQ(a.finalized, round);
    }
}

TEST(WithoutRunner, StepIsThatOfASimulationActivity) {
    {
        Stepping<extras::SimulationActivity> a(0.001);
        ASSERT_TRUE(a.start());
        EXPECT_TRUE(extras::SimulationThread::Instance()->run(3));
        EXPECT_TRUE(a.execute());
        EXPECT_EQ(a.steps, 4);
        EXPECT_TRUE(a.stop());
        EXPECT_EQ(a.finalized, 1);
    }
    extras::SimulationThread::Release();
}

TEST(WithoutRunner, StepIsThatOfASequentialActivity) {
    Stepping<extras::SequentialActivity> a;
    EXPECT_FALSE(a.trigger());
    for (int round = 1; round <= 2; ++round) {
        ASSERT_TRUE(a.start());
        EXPECT_TRUE(a.trigger());
        EXPECT_TRUE(a.timeout());
        EXPECT_EQ(a.steps, 2 * round);
        EXPECT_TRUE(a.stop());
        EXPECT_EQ(a.initialized, round);
        EXPECT_EQ(a.finalized, round);
    }
}

TEST(WithoutRunner, StepIsThatOfASlaveActivityPeriodicOrNot) {
    for (const double period : {0.0, 0.01}) {
        Stepping<extras::SlaveActivity> a(period);
        EXPECT_FALSE(a.execute());
        for (int round = 1; round <= 2; ++round) {
            ASSERT_TRUE(a.start());
            EXPECT_TRUE(a.execute());
            EXPECT_EQ(a.steps, round);
            EXPECT_TRUE(a.stop());
            EXPECT_EQ(a.initialized, round);
            EXPECT_EQ(a.finalized, round);
        }
    }
}

TEST(WithoutRunner, LoopIsThatOfASlaveActivityWithoutPeriod) {
    Looping<extras::SlaveActivity> a(0.0);
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(a.execute());
    EXPECT_EQ(a.loops, 1);
    Looping<extras::SlaveActivity> periodic(0.01);
    ASSERT_TRUE(periodic.start());
    EXPECT_TRUE(periodic.execute());
    EXPECT_EQ(periodic.loops, 0);
}

TEST(WithoutRunner, StepIsThatOfAFileDescriptorActivity) {
    Stepping<extras::FileDescriptorActivity> a(ORO_SCHED_OTHER, 0);
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(a.trigger());
    EXPECT_TRUE(eventually([&] { return a.steps == 1; }));
    EXPECT_TRUE(a.timeout());
    EXPECT_TRUE(eventually([&] { return a.steps == 2; }));
    EXPECT_TRUE(a.stop());
    EXPECT_EQ(a.finalized, 1);
}

TEST(WithoutRunner, WhatASlaveTriggersIsItsOwn) {
    struct Slave : extras::SlaveActivity {
        using extras::SlaveActivity::SlaveActivity;
        ~Slave() override { stop(); }
        void work(base::RunnableInterface::WorkReason reason) override {
            ++(reason == base::RunnableInterface::Trigger ? triggers : timeouts);
        }
        int triggers = 0, timeouts = 0;
    };
    struct MasterRunner : base::RunnableInterface {
        bool initialize() override { return true; }
        void step() override {}
        void finalize() override {}
        bool process(base::DisposableInterface* message) override { return message->executeAndDispose(), true; }
    } runner;
    extras::SequentialActivity master(&runner);
    Slave slave(&master);
    ASSERT_TRUE(master.start() && slave.start());
    EXPECT_TRUE(slave.trigger());
    EXPECT_TRUE(slave.execute());
    EXPECT_EQ(slave.triggers, 1);
    EXPECT_EQ(slave.timeouts, 1);
}

}  // namespace
