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

TEST(Activity, TooManyOverrunsAreReported) {
    const oroforge::test::LogCapture log;
    CountingRunner r;
    r.onStep = [] { usleep(4000); };
    Activity a(ORO_SCHED_OTHER, 0, 0.001, &r, "late");
    a.setMaxOverrun(3);
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return log.count(2, "setMaxOverrun()") == 1; }));
    EXPECT_EQ(log.count(2, "thread 'late' stopped: it has missed its period 3 times too often"), 1);
}

TEST(Activity, OverrunsAreCountedUnderTheRelativePolicyToo) {
    CountingRunner r;
    r.onStep = [] { usleep(4000); };
    Activity a(ORO_SCHED_OTHER, 0, 0.001, &r);
    a.setWaitPeriodPolicy(ORO_WAIT_REL);
    a.setMaxOverrun(3);
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return !a.isActive(); }));
    EXPECT_EQ(r.finalized, 1);
}

TEST(Activity, OverrunsAreNotCountedByDefault) {
    CountingRunner r;
    r.onStep = [] { usleep(2000); };
    Activity a(ORO_SCHED_OTHER, 0, 0.0005, &r);
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return r.timeouts >= 20; }));
    EXPECT_TRUE(a.isActive());
}

TEST(Activity, PeriodMayBeSetBeforeTheStart) {
    CountingRunner r;
    Activity a(&r);
    EXPECT_TRUE(a.setPeriod(0.002));
    EXPECT_EQ(r.triggers, 0);
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return r.timeouts >= 2; }));
    EXPECT_EQ(r.loops, 0);
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

TEST(Activity, MayHaveAPeriodThatNeverEnds) {
    CountingRunner r;
    Activity a(ORO_SCHED_OTHER, 0, InfiniteSeconds, &r);
    EXPECT_TRUE(a.isPeriodic());
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(eventually([&] { return r.triggers == 1; }));
    EXPECT_TRUE(a.trigger());
    EXPECT_TRUE(eventually([&] { return r.triggers == 2; }));
    usleep(5000);
    EXPECT_EQ(r.timeouts, 0);
    a.setStopTimeout(InfiniteSeconds);
    EXPECT_TRUE(a.stop());
    EXPECT_FALSE(a.stop());
}
