// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "os_test.hpp"

#include <rtt/Activity.hpp>
#include <rtt/os/Semaphore.hpp>

#include <mutex>
#include <stdexcept>
#include <string>

using namespace RTT;
using oroforge::test::CountingRunner;
using oroforge::test::eventually;

TEST(Activity, ConstructorsSelectTheScheduler) {
    EXPECT_EQ(Activity().getPriority(), 0);
    EXPECT_EQ(Activity().getScheduler(), ORO_SCHED_OTHER);
    EXPECT_STREQ(Activity().getName(), "Activity");
    EXPECT_EQ(Activity(ORO_SCHED_OTHER, 0, nullptr, "four").getPeriod(), 0.0);
    EXPECT_EQ(Activity(ORO_SCHED_OTHER, 0, 0.01, nullptr, "five").getPeriod(), 0.01);
    EXPECT_EQ(Activity(20, 0.25).getPeriod(), 0.25);
    EXPECT_FALSE(Activity(20).isPeriodic());
    Activity pinned(ORO_SCHED_OTHER, 0, 0.5, 1u, nullptr, "six");
    EXPECT_EQ(pinned.getCpuAffinity(), 1u);
    EXPECT_TRUE(pinned.isPeriodic());
}

TEST(Activity, CallsOfExistingComponentsSelectTheConstructorTheyMean) {
    CountingRunner r;
    EXPECT_EQ(Activity(20, 0.01, &r, "name").getPeriod(), 0.01);
    EXPECT_EQ(Activity(20, 0.01, 0, "name").getPeriod(), 0.01);
    EXPECT_EQ(Activity(ORO_SCHED_OTHER, 0, 0.01, 0, "name").getPeriod(), 0.01);
    EXPECT_EQ(Activity(ORO_SCHED_OTHER, 0, 0.01, 0, 0, "name").getPeriod(), 0.01);
    EXPECT_EQ(Activity(ORO_SCHED_OTHER, 0, 0, 1, &r, "name").getCpuAffinity(), 1u);
    EXPECT_STREQ(Activity(os::LowestPriority, &r, "name").getName(), "name");
    EXPECT_STREQ(Activity(&r, "name").getName(), "name");
}

TEST(Activity, OptionsAreGivenByName) {
    CountingRunner r;
    Activity::Options options;
    options.name = "named";
    options.period = 0.125;
    options.cpuAffinity = 1u;
    options.maxOverrun = 7;
    options.stopTimeout = 3.0;
    Activity a(options, &r);
    EXPECT_STREQ(a.getName(), "named");
    EXPECT_EQ(a.getPeriod(), 0.125);
    EXPECT_EQ(a.getCpuAffinity(), 1u);
    EXPECT_EQ(a.getMaxOverrun(), 7);
    EXPECT_EQ(a.getStopTimeout(), 3.0);
    EXPECT_EQ(r.getActivity(), &a);
    EXPECT_EQ(Activity(Activity::Options()).getStopTimeout(), 1.0);
    EXPECT_EQ(Activity(Activity::Options()).getMaxOverrun(), -1);
}

TEST(Activity, StopsWithinASecondWhateverItsPeriod) {
    EXPECT_EQ(Activity(ORO_SCHED_OTHER, 0, 0.5).getStopTimeout(), 1.0);
    EXPECT_EQ(Activity(ORO_SCHED_OTHER, 0, 0.001).getStopTimeout(), 1.0);
    os::Thread::setLockTimeoutNoPeriod(4.0);
    EXPECT_EQ(Activity(ORO_SCHED_OTHER, 0, 0.5).getStopTimeout(), 4.0);
    os::Thread::setLockTimeoutNoPeriod(1.0);
}

TEST(Activity, ReportsItsPeriodWhenItIsCreated) {
    const oroforge::test::LogCapture log;
    Activity periodic(ORO_SCHED_OTHER, 0, 0.02, nullptr, "periodic");
    EXPECT_EQ(log.count(5, "created thread 'periodic'"), 1);
    EXPECT_EQ(log.count(5, "period 0.02 s, PID " + std::to_string(periodic.getPid())), 1);
    Activity triggered(ORO_SCHED_OTHER, 0, 0.0, nullptr, "triggered");
    EXPECT_EQ(log.count(5, "period 0 s, PID " + std::to_string(triggered.getPid())), 1);
}

TEST(Activity, RunConnectsBothSides) {
    CountingRunner r;
    {
        Activity a;
        EXPECT_TRUE(a.run(&r));
        EXPECT_EQ(r.getActivity(), &a);
        EXPECT_EQ(r.getThread(), a.thread());
        ASSERT_TRUE(a.start());
        EXPECT_FALSE(a.run(nullptr));
        EXPECT_TRUE(eventually([&] { return a.stop(); }));
    }
    EXPECT_EQ(r.getActivity(), nullptr);
    Activity a;
    {
        CountingRunner shortLived;
        EXPECT_TRUE(a.run(&shortLived));
    }
    EXPECT_EQ(a.getRunner(), nullptr);
}

TEST(Activity, FailingInitializePreventsStart) {
    CountingRunner r;
    r.initializeResult = false;
    Activity a(&r);
    EXPECT_FALSE(a.start());
    EXPECT_FALSE(a.isActive());
    EXPECT_FALSE(a.trigger());
    EXPECT_FALSE(a.stop());
}

TEST(Activity, NonPeriodicExecutesLoopAndTriggerOnStartAndTrigger) {
    CountingRunner r;
    Activity a(&r);
    EXPECT_FALSE(a.trigger());
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(a.isActive());
    EXPECT_TRUE(a.isRunning());
    EXPECT_TRUE(eventually([&] { return r.loops == 1 && r.triggers == 1; }));
    EXPECT_TRUE(a.trigger());
    EXPECT_TRUE(eventually([&] { return r.loops == 2 && r.triggers == 2; }));
    EXPECT_TRUE(a.start());  // again: a wake-up
    EXPECT_TRUE(eventually([&] { return r.loops == 3 && r.triggers == 3; }));
    EXPECT_EQ(r.steps, 0);
    EXPECT_EQ(r.timeouts, 0);
    EXPECT_FALSE(a.execute());
    EXPECT_TRUE(a.stop());
    EXPECT_FALSE(a.trigger());
    EXPECT_EQ(r.initialized, 1);
    EXPECT_EQ(r.finalized, 1);
}

TEST(Activity, SubClassWithoutRunnerMayHaveAStepOnly) {
    struct Stepping : Activity {
        using Activity::Activity;
        ~Stepping() override { stop(); }
        void step() override { ++steps; }
        std::atomic<int> steps{0};
    } a;
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return a.steps == 1; }));
    EXPECT_TRUE(a.trigger());
    EXPECT_TRUE(eventually([&] { return a.steps == 2; }));
    EXPECT_TRUE(a.stop());
    EXPECT_EQ(a.steps, 2);
}

TEST(Activity, TimeoutExecutesStepAndTimeOut) {
    CountingRunner r;
    Activity a(&r);
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(eventually([&] { return r.triggers == 1; }));
    EXPECT_TRUE(a.timeout());
    EXPECT_TRUE(eventually([&] { return r.steps == 1 && r.timeouts == 1; }));
    EXPECT_EQ(r.loops, 1);
}

TEST(Activity, TimeoutBeforeStartIsRemembered) {
    CountingRunner r;
    Activity a(&r);
    EXPECT_TRUE(a.timeout());
    usleep(2000);
    EXPECT_EQ(r.timeouts, 0);
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return r.timeouts == 1; }));
}

TEST(Activity, StopAsksBreakLoopWhileExecuting) {
    CountingRunner r;
    std::atomic<bool> inside{false}, leave{false};
    r.onLoop = [&] {
        inside = true;
        eventually([&] { return leave.load(); });
    };
    r.breakResult = false;
    Activity a(&r);
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_FALSE(a.stop());
    EXPECT_EQ(r.breaks, 1);
    EXPECT_TRUE(a.isActive());
    EXPECT_TRUE(a.isRunning());
    leave = true;
    r.breakResult = true;
    EXPECT_TRUE(eventually([&] { return a.stop(); }));
    EXPECT_EQ(r.finalized, 1);
}

TEST(Activity, FailedStopKeepsItWorking) {
    CountingRunner r;
    std::atomic<bool> inside{false}, leave{false};
    r.onLoop = [&] {
        inside = true;
        eventually([&] { return leave.load(); });
    };
    Activity a(&r);
    a.setStopTimeout(0.02);
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_FALSE(a.stop());
    leave = true;
    const int triggers = r.triggers;
    EXPECT_TRUE(eventually([&] { return r.triggers > triggers; }));
    EXPECT_TRUE(a.timeout());
    EXPECT_TRUE(eventually([&] { return r.timeouts == 1; }));
    a.setStopTimeout(20.0);
    EXPECT_TRUE(a.stop());
}

TEST(Activity, StopFromItsOwnThreadThenStart) {
    CountingRunner r;
    Activity a(&r);
    std::atomic<bool> stopped{false}, activeAfter{true};
    r.onWork = [&](auto) {
        if (r.triggers == 2) {
            stopped = a.stop();
            activeAfter = a.isActive();
        }
    };
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(eventually([&] { return r.triggers == 1; }));
    a.trigger();
    ASSERT_TRUE(eventually([&] { return !a.isActive(); }));
    EXPECT_TRUE(eventually([&] { return stopped.load(); }));
    EXPECT_FALSE(activeAfter);
    EXPECT_EQ(r.finalized, 1);
    EXPECT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return r.triggers == 3; }));
}

TEST(Activity, RestartFromItsOwnThreadKeepsItRunning) {
    CountingRunner r;
    Activity a(ORO_SCHED_OTHER, 0, 0.002, &r);
    std::atomic<bool> done{false};
    r.onStep = [&] {
        if (!done.exchange(true)) {
            EXPECT_TRUE(a.stop());
            EXPECT_TRUE(a.start());
        }
    };
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return r.timeouts >= 5; }));
    EXPECT_TRUE(a.isActive());
    EXPECT_EQ(r.initialized, 2);
    EXPECT_TRUE(a.stop());
}

TEST(Activity, ExceptionStopsIt) {
    CountingRunner r;
    r.onWork = [](auto) { throw std::runtime_error("boom"); };
    Activity a(&r);
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return !a.isActive(); }));
    EXPECT_EQ(r.finalized, 1);
    r.onWork = nullptr;
    EXPECT_TRUE(a.start());
}

TEST(Activity, SubClassMayReplaceTheRunner) {
    struct Publisher : Activity {
        std::atomic<int> loops{0}, steps{0};
        Publisher() : Activity(ORO_SCHED_OTHER, 0, 0.0, nullptr, "Publisher") {}
        ~Publisher() override { stop(); }
        void loop() override { ++loops; }
        void step() override { ++steps; }
        bool breakLoop() override { return true; }
    } a;
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(eventually([&] { return a.loops == 1; }));
    a.trigger();
    EXPECT_TRUE(eventually([&] { return a.loops == 2; }));
    a.timeout();
    EXPECT_TRUE(eventually([&] { return a.steps == 1; }));
}

TEST(Activity, KnowsItsThread) {
    CountingRunner r;
    Activity a(&r);
    std::atomic<bool> self{false};
    r.onWork = [&](auto) { self = a.isSelf() && a.thread()->isSelf() && r.getActivity()->isSelf(); };
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return self.load(); }));
    EXPECT_FALSE(a.isSelf());
}
