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

TEST(Activity, PeriodicBeginsWithTriggerThenStepsEachPeriod) {
    std::mutex mutex;
    std::string order;
    CountingRunner r;
    r.onStep = [&] {
        std::lock_guard<std::mutex> lock(mutex);
        order += 's';
    };
    r.onWork = [&](auto reason) {
        std::lock_guard<std::mutex> lock(mutex);
        order += reason == base::RunnableInterface::TimeOut ? 'O' : 'T';
    };
    Activity a(ORO_SCHED_OTHER, 0, 0.005, &r);
    const nsecs before = rtos_get_time_ns();
    ASSERT_TRUE(a.start());
    EXPECT_FALSE(a.start());
    EXPECT_FALSE(a.timeout());
    EXPECT_TRUE(eventually([&] { return r.timeouts >= 4; }));
    EXPECT_GE(rtos_get_time_ns() - before, 4 * 5000000);
    EXPECT_TRUE(a.stop());
    EXPECT_EQ(order.substr(0, 5), "TsOsO");
    EXPECT_EQ(r.loops, 0);
    EXPECT_EQ(r.breaks, 0);
}

TEST(Activity, TriggerBetweenPeriods) {
    CountingRunner r;
    Activity a(ORO_SCHED_OTHER, 0, 30.0, &r);
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(eventually([&] { return r.triggers == 1; }));
    EXPECT_EQ(r.steps, 0);
    EXPECT_TRUE(a.trigger());
    EXPECT_TRUE(eventually([&] { return r.triggers == 2 && r.steps == 1; }));
    EXPECT_EQ(r.timeouts, 0);
    const nsecs before = rtos_get_time_ns();
    EXPECT_TRUE(a.stop());
    EXPECT_LT(rtos_get_time_ns() - before, Seconds_to_nsecs(20.0));  // does not wait for the period
}

TEST(Activity, AbsolutePolicyCatchesUp) {
    CountingRunner r;
    std::atomic<bool> slow{true};
    r.onStep = [&] {
        if (slow.exchange(false)) usleep(100000);
    };
    Activity a(ORO_SCHED_OTHER, 0, 0.01, &r);
    a.setWaitPeriodPolicy(ORO_WAIT_ABS);
    const nsecs start = rtos_get_time_ns();
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(eventually([&] { return r.timeouts >= 20; }));
    const nsecs took = rtos_get_time_ns() - start;
    a.stop();
    EXPECT_GE(took, 20 * 10000000LL - 1000000);
    // No period is skipped: as many as have passed, whatever the machine was doing meanwhile.
    EXPECT_LE(r.timeouts, (rtos_get_time_ns() - start) / 10000000);
}

TEST(Activity, RelativePolicyKeepsItsDistance) {
    std::mutex mutex;
    std::vector<nsecs> at;
    CountingRunner r;
    r.onStep = [&] {
        std::lock_guard<std::mutex> lock(mutex);
        at.push_back(rtos_get_time_ns());
        if (at.size() == 2) usleep(50000);  // five periods
    };
    Activity a(ORO_SCHED_OTHER, 0, 0.01, &r);
    a.setWaitPeriodPolicy(ORO_WAIT_REL);
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(eventually([&] { return r.timeouts >= 6; }));
    a.stop();
    // At most one cycle follows at once; there is no burst of five.
    EXPECT_GE(at[4] - at[3], 5000000);
    EXPECT_GE(at[5] - at[4], 5000000);
}

TEST(Activity, TooManyOverrunsStopIt) {
    CountingRunner r;
    r.onStep = [] { usleep(4000); };
    Activity a(ORO_SCHED_OTHER, 0, 0.001, &r);
    a.setMaxOverrun(4);
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return !a.isActive(); }));
    EXPECT_FALSE(a.isRunning());
    EXPECT_EQ(r.finalized, 1);
    r.onStep = nullptr;
    a.setMaxOverrun(-1);
    EXPECT_TRUE(a.start());
}

TEST(Activity, SetPeriodAtAnyTime) {
    CountingRunner r;
    Activity a(&r);
    EXPECT_FALSE(a.setPeriod(-1.0));
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(eventually([&] { return r.triggers == 1; }));
    EXPECT_TRUE(a.setPeriod(0.002));
    EXPECT_TRUE(a.isPeriodic());
    EXPECT_TRUE(eventually([&] { return r.timeouts >= 3; }));
    EXPECT_TRUE(a.setPeriod(0.0));
    EXPECT_FALSE(a.isPeriodic());
    ASSERT_TRUE(eventually([&] { return r.loops >= 2; }));  // the change itself triggers
    const int timeouts = r.timeouts;
    usleep(10000);
    EXPECT_EQ(r.timeouts, timeouts);
    EXPECT_TRUE(a.timeout());
    EXPECT_TRUE(eventually([&] { return r.timeouts == timeouts + 1; }));
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
