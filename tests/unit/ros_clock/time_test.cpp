// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The times, and the switches of simulated time.
#include "clock_test.hpp"

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SimulationThread.hpp>

#include <thread>

namespace {

using namespace oroforge::test;
using namespace rtt_rosclock;

constexpr double kSoon = 5.0;

TEST(Times, WithoutASimulationAndWithoutRos) {
    EXPECT_NEAR(host_now().toSec(), ros::WallTime::now().toSec(), kSoon);
    EXPECT_NEAR(host_wall_now().toSec(), ros::WallTime::now().toSec(), kSoon);
    EXPECT_NEAR(rtt_now().toSec(), static_cast<double>(rtos_get_time_ns()) / 1e9, kSoon);
    EXPECT_NEAR(rtt_wall_now().toSec(), static_cast<double>(rtos_get_time_ns()) / 1e9, kSoon);
    EXPECT_NEAR(host_offset_from_rtt(), host_wall_now().toSec() - rtt_wall_now().toSec(), kSoon);
}

TEST(Times, OfASimulationAndAfterIt) {
    const auto reference = RTT::Logger::Instance()->getReferenceTime();
    ASSERT_TRUE(enable_sim());
    EXPECT_TRUE(enable_sim());
    EXPECT_EQ(RTT::Logger::Instance()->getReferenceTime(), 0);
    EXPECT_EQ(host_now(), ros::Time(0));
    ASSERT_TRUE(update_sim_clock(ros::Time(12, 345)));
    EXPECT_EQ(host_now(), ros::Time(12, 345));
    EXPECT_EQ(rtt_now(), ros::Time(12, 345));
    EXPECT_NEAR(host_wall_now().toSec(), ros::WallTime::now().toSec(), kSoon);
    EXPECT_NEAR(rtt_wall_now().toSec(), static_cast<double>(rtos_get_time_ns()) / 1e9, kSoon);
    EXPECT_NEAR(host_offset_from_rtt(), host_wall_now().toSec() - rtt_wall_now().toSec(), kSoon);
    ASSERT_TRUE(disable_sim());
    EXPECT_TRUE(disable_sim());
    EXPECT_EQ(RTT::Logger::Instance()->getReferenceTime(), reference);
    EXPECT_NEAR(rtt_now().toSec(), static_cast<double>(rtos_get_time_ns()) / 1e9, kSoon);
    EXPECT_NEAR(host_now().toSec(), ros::WallTime::now().toSec(), kSoon);
    ASSERT_TRUE(enable_sim());
    EXPECT_EQ(rtt_now(), ros::Time(0));
    ASSERT_TRUE(disable_sim());
}

TEST(Switches, TheSourceStaysWhileEnabled) {
    EXPECT_FALSE(update_sim_clock(ros::Time(1)));
    EXPECT_TRUE(use_ros_clock_topic());
    EXPECT_FALSE(enable_sim());  // no node
    EXPECT_TRUE(RTT::os::TimeService::Instance()->systemClockEnabled());
    EXPECT_TRUE(use_manual_clock());
    ASSERT_TRUE(enable_sim());
    EXPECT_FALSE(use_ros_clock_topic());
    EXPECT_TRUE(use_manual_clock());
    EXPECT_TRUE(update_sim_clock(ros::Time(1)));
    ASSERT_TRUE(disable_sim());
}

TEST(Switches, ThereIsOneSimulationAtATime) {
    const RTT::extras::SimulationThreadPtr other = RTT::extras::SimulationThread::Instance();
    ASSERT_TRUE(other->start());
    EXPECT_TRUE(eventually([] { return !RTT::os::TimeService::Instance()->systemClockEnabled(); }));
    EXPECT_FALSE(enable_sim());
    EXPECT_TRUE(eventually([&] { return other->stop(); }));
    EXPECT_TRUE(enable_sim());
    EXPECT_TRUE(disable_sim());
}

TEST_F(ManualClock, AnActivityMayMoveTheTimeAndEndIt) {
    Recorder r, other;
    SimClockActivity a(0.01, &r), b(0.01, &other);
    r.onStep = [&] {
        if (r.at.size() == 5)
            disable_sim();
        else
            EXPECT_TRUE(update(static_cast<nsecs>(r.at.size() + 1) * 10 * kMs));
    };
    ASSERT_TRUE(a.start() && b.start() && update(10 * kMs));
    EXPECT_TRUE(eventually([] { return RTT::os::TimeService::Instance()->systemClockEnabled(); }));
    EXPECT_TRUE(a.stop() && b.stop());
    EXPECT_EQ(r.at, (std::vector<nsecs>{10 * kMs, 20 * kMs, 30 * kMs, 40 * kMs, 50 * kMs}));
    EXPECT_EQ(other.at.size(), 4u);
}

TEST_F(ManualClock, EndingItReleasesTheThreadThatWaits) {
    std::atomic<bool> entered{false}, leave{false};
    Recorder r;
    SimClockActivity a(0.01, &r);
    r.onStep = [&] {
        entered = true;
        eventually([&] { return leave.load(); });
    };
    ASSERT_TRUE(a.start());
    std::thread source([] { EXPECT_FALSE(update(10 * kMs)); });
    EXPECT_TRUE(eventually([&] { return entered.load(); }));
    EXPECT_TRUE(disable_sim());
    source.join();
    leave = true;
}

TEST(Component, GetsItsActivityOnce) {
    EXPECT_FALSE(set_sim_clock_activity(nullptr));
    RTT::TaskContext c("c");
    c.setPeriod(0.25);
    ASSERT_TRUE(set_sim_clock_activity(&c));
    auto* const activity = dynamic_cast<SimClockActivity*>(c.getActivity());
    ASSERT_NE(activity, nullptr);
    EXPECT_EQ(c.getPeriod(), 0.25);
    EXPECT_EQ(activity->getName(), "c");
    EXPECT_TRUE(set_sim_clock_activity(&c));
    EXPECT_EQ(c.getActivity(), activity);
    RTT::TaskContext running("running");
    ASSERT_TRUE(running.start());
    EXPECT_FALSE(set_sim_clock_activity(&running));
    ASSERT_TRUE(running.stop());
    EXPECT_TRUE(set_sim_clock_activity(&running));
}

}  // namespace
