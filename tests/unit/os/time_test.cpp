// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Time.hpp>
#include <rtt/os/TimeService.hpp>

#include <gtest/gtest.h>

using namespace RTT;

TEST(Time, ConversionsRoundToTheNearestNanosecond) {
    EXPECT_EQ(Seconds_to_nsecs(0.001), 1000000);
    EXPECT_EQ(Seconds_to_nsecs(0.1), 100000000);
    EXPECT_EQ(Seconds_to_nsecs(-0.1), -100000000);
    EXPECT_EQ(nsecs_to_Seconds(10000000), 0.01);
    EXPECT_EQ(msecs_to_nsecs(3), 3000000);
    EXPECT_EQ(usecs_to_nsecs(3), 3000);
    EXPECT_EQ(Seconds_to_msecs(1.5), 1500);
    EXPECT_EQ(nsecs_to_msecs(2500000), 2);
}

TEST(Time, WhatDoesNotFitIsClamped) {
    EXPECT_EQ(Seconds_to_nsecs(InfiniteSeconds), InfiniteNSecs);
    EXPECT_EQ(Seconds_to_nsecs(-InfiniteSeconds), -InfiniteNSecs);
    EXPECT_EQ(Seconds_to_nsecs(std::numeric_limits<double>::quiet_NaN()), 0);
}

// What nobody can set never jumps.
TEST(Time, IsThatOfTheMonotonicClock) {
    const auto monotonic = [] {
        timespec now;
        clock_gettime(CLOCK_MONOTONIC, &now);
        return static_cast<nsecs>(now.tv_sec) * 1000000000 + now.tv_nsec;
    };
    const nsecs before = monotonic();
    const nsecs time = rtos_get_time_ns();
    const nsecs ticks = os::TimeService::ticks2nsecs(os::TimeService::Instance()->getTicks());
    EXPECT_LE(before, time);
    EXPECT_LE(time, ticks);
    EXPECT_LE(ticks, monotonic());
}

class TimeServiceTest : public testing::Test {
protected:
    ~TimeServiceTest() override { os::TimeService::Release(); }
    os::TimeService& time = *os::TimeService::Instance();
};

TEST_F(TimeServiceTest, NeverGoesBack) {
    const os::TimeService::ticks before = time.getTicks();
    EXPECT_GE(time.getTicks(), before);
    EXPECT_GE(time.ticksSince(before), 0);
    EXPECT_GE(time.secondsSince(before), 0.0);
    EXPECT_LT(time.secondsSince(before), 60.0);
    EXPECT_GE(time.getNSecs(time.getNSecs()), 0);
}

TEST_F(TimeServiceTest, AVariableThatIsZeroIsSetToThePresentTime) {
    os::TimeService::ticks ticks = 0;
    os::TimeService::nsecs ns = 0;
    os::TimeService::Seconds seconds = 0;
    time.enableSystemClock(false);
    EXPECT_EQ(time.getTicks(ticks), time.getTicks());
    EXPECT_EQ(time.getNSecs(ns), time.getNSecs());
    EXPECT_EQ(time.getSeconds(seconds), time.getSeconds());
    EXPECT_EQ(ticks, time.getTicks());
    EXPECT_EQ(ns, time.getNSecs());
    EXPECT_EQ(seconds, time.getSeconds());
    time.secondsChange(2.0);
    EXPECT_EQ(time.getTicks(ticks), os::TimeService::nsecs2ticks(2000000000));
    EXPECT_EQ(time.getNSecs(ns), 2000000000);
    EXPECT_NEAR(time.getSeconds(seconds), 2.0, 1e-6);
    const os::TimeService::ticks since = ticks;  // and what cannot be set
    EXPECT_EQ(time.getTicks(since), time.getTicks() - since);
    EXPECT_EQ(time.getTicks(0), time.getTicks());
}

TEST_F(TimeServiceTest, ChangeMovesTheTime) {
    const os::TimeService::ticks before = time.getTicks();
    EXPECT_GE(time.secondsChange(100.0), 100.0);
    EXPECT_GE(time.ticksSince(before), Seconds_to_nsecs(100.0));
    time.secondsChange(-100.0);
    EXPECT_LT(time.secondsSince(before), 60.0);
}

TEST_F(TimeServiceTest, WithoutClockOnlyChangesMoveIt) {
    const os::TimeService::ticks before = time.getTicks();
    time.enableSystemClock(false);
    EXPECT_FALSE(time.systemClockEnabled());
    const os::TimeService::ticks frozen = time.getTicks();
    EXPECT_GE(frozen, before);
    EXPECT_EQ(time.getTicks(), frozen);
    EXPECT_EQ(time.ticksChange(5), frozen + 5);
    EXPECT_EQ(time.ticksChange(-7), frozen - 2);
    time.enableSystemClock(false);  // no change
    EXPECT_EQ(time.getTicks(), frozen - 2);
    time.enableSystemClock(true);
    EXPECT_GE(time.getTicks(), frozen - 2);
    EXPECT_LT(time.getTicks() - frozen, Seconds_to_nsecs(60.0));
}
