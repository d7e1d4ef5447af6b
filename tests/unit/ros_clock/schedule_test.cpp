// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// When activities execute.
#include "clock_test.hpp"

#include <stdexcept>

namespace {

using namespace oroforge::test;
using rtt_rosclock::SimClockActivity;

using Schedule = ManualClock;

void expectMultiples(const std::vector<nsecs>& at, nsecs period, std::size_t count) {
    ASSERT_EQ(at.size(), count);
    for (std::size_t i = 0; i != count; ++i) ASSERT_EQ(at[i], static_cast<nsecs>(i + 1) * period);
}

TEST_F(Schedule, PeriodsAreExactOverTenThousandSteps) {
    Recorder fast, slow, every;
    SimClockActivity a(0.01, &fast), b(0.025, &slow), c(&every);
    ASSERT_TRUE(a.start() && b.start() && c.start());
    for (nsecs step = 1; step <= 10000; ++step) ASSERT_TRUE(update(step * 5 * kMs));
    expectMultiples(fast.at, 10 * kMs, 5000);
    expectMultiples(slow.at, 25 * kMs, 2000);
    expectMultiples(every.at, 5 * kMs, 10000);
}

TEST_F(Schedule, StepsNeedNotDivideThePeriods) {
    Recorder fast, slow;
    SimClockActivity a(0.01, &fast), b(0.025, &slow);
    ASSERT_TRUE(a.start() && b.start());
    nsecs now = 0;
    for (nsecs step = 0; step != 10000; ++step) ASSERT_TRUE(update(now += 1 * kMs + step % 7 * kMs));
    EXPECT_EQ(simulated(), now);
    expectMultiples(fast.at, 10 * kMs, static_cast<std::size_t>(now / (10 * kMs)));
    expectMultiples(slow.at, 25 * kMs, static_cast<std::size_t>(now / (25 * kMs)));
}

TEST_F(Schedule, WhatAStepMissesIsCaughtUpInOrderOfTime) {
    std::vector<std::pair<char, nsecs>> all;
    Recorder first, second;
    first.onStep = [&] { all.push_back({'a', simulated() / kMs}); };
    second.onStep = [&] { all.push_back({'b', simulated() / kMs}); };
    SimClockActivity a(0.02, &first), b(0.01, &second);
    ASSERT_TRUE(b.start() && a.start());
    ASSERT_TRUE(update(45 * kMs));
    const std::vector<std::pair<char, nsecs>> expected{{'b', 10}, {'a', 20}, {'b', 20},
                                                       {'b', 30}, {'a', 40}, {'b', 40}};
    EXPECT_EQ(all, expected);  // a was created first
    EXPECT_EQ(simulated(), 45 * kMs);
}

TEST_F(Schedule, BackwardsDueTimesAreSetAnew) {
    Recorder r, every;
    SimClockActivity a(0.01, &r), c(&every);
    ASSERT_TRUE(a.start() && c.start());
    ASSERT_TRUE(update(100 * kMs));
    r.at.clear();
    every.at.clear();
    ASSERT_TRUE(update(55 * kMs));
    EXPECT_TRUE(r.at.empty());
    EXPECT_EQ(simulated(), 55 * kMs);
    ASSERT_TRUE(update(60 * kMs) && update(65 * kMs) && update(70 * kMs));
    EXPECT_EQ(r.at, (std::vector<nsecs>{60 * kMs, 70 * kMs}));
    EXPECT_EQ(every.at, (std::vector<nsecs>{55 * kMs, 60 * kMs, 65 * kMs, 70 * kMs}));
}

TEST_F(Schedule, ZeroResetsAndARepeatedTimeIsNoStep) {
    Recorder r, every;
    SimClockActivity a(0.01, &r), c(&every);
    ASSERT_TRUE(a.start() && c.start());
    ASSERT_TRUE(update(30 * kMs) && update(30 * kMs));
    EXPECT_EQ(every.at.size(), 1u);
    ASSERT_TRUE(update(0));
    EXPECT_EQ(simulated(), 0);
    EXPECT_EQ(r.at.size(), 3u);
    EXPECT_EQ(every.at.size(), 1u);
    ASSERT_TRUE(update(10 * kMs));
    EXPECT_EQ(r.at.back(), 10 * kMs);
    EXPECT_EQ(r.at.size(), 4u);
}

TEST_F(Schedule, ThePeriodCanChange) {
    Recorder r;
    SimClockActivity a(0.01, &r, "a");
    EXPECT_TRUE(a.isPeriodic());
    EXPECT_EQ(a.getName(), "a");
    EXPECT_FALSE(a.setPeriod(-1));
    EXPECT_FALSE(a.trigger());  // not active
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(a.isActive() && a.isRunning());
    EXPECT_FALSE(a.start());
    EXPECT_FALSE(a.execute() || a.timeout());
    EXPECT_TRUE(a.trigger());
    ASSERT_TRUE(update(15 * kMs));
    ASSERT_TRUE(a.setPeriod(0.1));
    EXPECT_EQ(a.getPeriod(), 0.1);
    ASSERT_TRUE(update(90 * kMs) && update(100 * kMs));
    EXPECT_EQ(r.at, (std::vector<nsecs>{10 * kMs, 100 * kMs}));
    ASSERT_TRUE(a.setPeriod(0));
    EXPECT_TRUE(a.isPeriodic());
    ASSERT_TRUE(update(101 * kMs));
    EXPECT_EQ(r.at.size(), 3u);
    ASSERT_TRUE(a.stop());
    EXPECT_FALSE(a.isRunning());
    ASSERT_TRUE(update(102 * kMs));
    EXPECT_EQ(r.at.size(), 3u);
}

TEST_F(Schedule, AnActivityThatIsStartedInAStepWaitsForTheNext) {
    Recorder first, second;
    SimClockActivity a(0.01, &first), b(0.01, &second);
    first.onStep = [&] { b.start(); };
    ASSERT_TRUE(a.start() && update(10 * kMs));
    EXPECT_TRUE(second.at.empty());
    ASSERT_TRUE(update(20 * kMs));
    EXPECT_EQ(second.at, (std::vector<nsecs>{20 * kMs}));
}

TEST_F(Schedule, AnExceptionStopsTheActivityAlone) {
    Recorder first, second;
    SimClockActivity a(0.01, &first), b(0.01, &second);
    first.onStep = [] { throw std::runtime_error("as the test wants"); };
    ASSERT_TRUE(a.start() && b.start());
    ASSERT_TRUE(update(10 * kMs) && update(20 * kMs));
    EXPECT_FALSE(a.isActive());
    EXPECT_EQ(first.at.size(), 1u);
    EXPECT_EQ(second.at.size(), 2u);
}

}  // namespace
