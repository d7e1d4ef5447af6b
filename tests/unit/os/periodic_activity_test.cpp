// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "os_test.hpp"

#include <rtt/extras/PeriodicActivity.hpp>

#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

using namespace RTT;
using extras::PeriodicActivity;
using extras::TimerThread;
using oroforge::test::CountingRunner;
using oroforge::test::eventually;

TEST(PeriodicActivity, EqualParametersShareAThread) {
    PeriodicActivity a(ORO_SCHED_OTHER, 0, 0.005);
    PeriodicActivity b(ORO_SCHED_OTHER, 0, 0.005);
    PeriodicActivity other(ORO_SCHED_OTHER, 0, 0.007);
    EXPECT_EQ(a.thread(), b.thread());
    EXPECT_NE(a.thread(), other.thread());
    EXPECT_STREQ(a.thread()->getName(), "TimerThreadInstance");
    EXPECT_EQ(a.getPeriod(), 0.005);
    EXPECT_FALSE(a.setPeriod(0.1));
    EXPECT_FALSE(a.trigger());
    EXPECT_FALSE(a.timeout());
    EXPECT_FALSE(a.execute());
}

TEST(PeriodicActivity, ExecutesInOrderOfStart) {
    std::mutex mutex;
    std::string order;
    CountingRunner first, second;
    const auto note = [&](char c) {
        std::lock_guard<std::mutex> lock(mutex);
        order += c;
    };
    first.onStep = [&] { note('a'); };
    second.onStep = [&] { note('b'); };
    PeriodicActivity a(ORO_SCHED_OTHER, 0, 0.003, &first);
    PeriodicActivity b(ORO_SCHED_OTHER, 0, 0.003, &second);
    ASSERT_TRUE(a.start());
    EXPECT_FALSE(a.start());
    ASSERT_TRUE(b.start());
    EXPECT_TRUE(a.isRunning());
    EXPECT_TRUE(eventually([&] { return second.timeouts >= 5; }));
    EXPECT_TRUE(a.stop());
    EXPECT_TRUE(b.stop());
    EXPECT_FALSE(a.isActive());
    EXPECT_NE(order.find("ababab"), std::string::npos) << order;
    EXPECT_EQ(first.steps, first.timeouts);
    const int steps = first.steps;
    usleep(10000);
    EXPECT_EQ(first.steps, steps);
}

TEST(PeriodicActivity, MayStopItselfAndItsNeighbour) {
    CountingRunner first, second;
    PeriodicActivity a(ORO_SCHED_OTHER, 0, 0.002, &first);
    PeriodicActivity b(ORO_SCHED_OTHER, 0, 0.002, &second);
    first.onStep = [&] {
        a.stop();
        b.stop();
    };
    ASSERT_TRUE(b.start());
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return !a.isActive() && !b.isActive(); }));
    EXPECT_TRUE(eventually([&] { return first.finalized == 1 && second.finalized == 1; }));
    first.onStep = nullptr;
    EXPECT_TRUE(b.start());
    const int steps = second.steps;
    EXPECT_TRUE(eventually([&] { return second.steps > steps; }));
}

TEST(PeriodicActivity, ExceptionStopsOnlyThatOne) {
    CountingRunner bad, good;
    bad.onStep = [] { throw std::runtime_error("boom"); };
    PeriodicActivity a(ORO_SCHED_OTHER, 0, 0.002, &bad);
    PeriodicActivity b(ORO_SCHED_OTHER, 0, 0.002, &good);
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(b.start());
    EXPECT_TRUE(eventually([&] { return !a.isActive() && good.steps > 3; }));
    EXPECT_EQ(bad.finalized, 1);
}

TEST(PeriodicActivity, ThreadTakesALimitedNumber) {
    const extras::TimerThreadPtr thread(new TimerThread(ORO_SCHED_OTHER, 0, "limited", 0.01));
    std::vector<std::unique_ptr<CountingRunner>> runners;
    std::vector<std::unique_ptr<PeriodicActivity>> activities;
    for (std::size_t i = 0; i <= TimerThread::MaxActivities; ++i) {
        runners.emplace_back(new CountingRunner);
        activities.emplace_back(new PeriodicActivity(thread, runners.back().get()));
        EXPECT_EQ(activities.back()->start(), i < TimerThread::MaxActivities);
    }
    EXPECT_FALSE(activities.back()->isActive());
    EXPECT_TRUE(activities.front()->stop());
    EXPECT_TRUE(activities.back()->start());
    activities.clear();
}

TEST(PeriodicActivity, SetsThePeriodOfAThreadOfYours) {
    const extras::TimerThreadPtr thread(new TimerThread(ORO_SCHED_OTHER, 0, "mine", 0.5));
    PeriodicActivity a(0, 4000000, thread);
    EXPECT_EQ(a.getPeriod(), 0.004);
}
