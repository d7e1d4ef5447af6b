// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_UNIT_ROS_CLOCK_CLOCK_TEST_HPP
#define OROFORGE_TESTS_UNIT_ROS_CLOCK_CLOCK_TEST_HPP

#include <rtt_rosclock/rtt_rosclock.h>
#include <rtt_rosclock/rtt_rosclock_sim_clock_activity.h>

#include <rtt/base/RunnableInterface.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/os/fosi.h>

#include <functional>
#include <gtest/gtest.h>
#include <unistd.h>
#include <vector>

namespace oroforge::test {

using RTT::nsecs;

constexpr nsecs kMs = 1000000;

inline nsecs simulated() { return RTT::os::TimeService::Instance()->getNSecs(); }
inline ros::Time rosTime(nsecs time) { return ros::Time().fromNSec(static_cast<uint64_t>(time)); }
inline bool update(nsecs time) { return rtt_rosclock::update_sim_clock(rosTime(time)); }

template <class Predicate>
bool eventually(Predicate&& predicate) {
    const long long end = rtos_get_time_ns() + 20000000000;
    while (!predicate()) {
        if (rtos_get_time_ns() > end) return false;
        usleep(200);
    }
    return true;
}

/// Remembers when it was executed.
struct Recorder : RTT::base::RunnableInterface {
    std::vector<nsecs> at;
    std::function<void()> onStep;
    bool initialize() override { return true; }
    void step() override {
        at.push_back(simulated());
        if (onStep) onStep();
    }
    void work(WorkReason) override {}
    void loop() override {}
    bool breakLoop() override { return true; }
    void finalize() override {}
};

/// A manual clock, enabled.
struct ManualClock : testing::Test {
    ManualClock() {
        EXPECT_TRUE(rtt_rosclock::use_manual_clock());
        EXPECT_TRUE(rtt_rosclock::enable_sim());
    }
    ~ManualClock() override { EXPECT_TRUE(rtt_rosclock::disable_sim()); }
};

}  // namespace oroforge::test

#endif
