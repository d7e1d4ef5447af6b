// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The topic /clock of a real master.
#include "clock_test.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <support/ros_master.hpp>

#include <chrono>
#include <csignal>
#include <map>
#include <string>
#include <thread>

namespace ros::master {
// roscpp has it, in no header that is installed.
void init(const std::map<std::string, std::string>& remappings);
}  // namespace ros::master

namespace {

using namespace oroforge::test;
using namespace rtt_rosclock;

struct ClockTopicTest : testing::Test {
    /// Makes this process a node that publishes /clock.
    void beNode(bool isSimulated = true) {
        int argc = 0;
        ros::init(argc, nullptr, "clock_test", ros::init_options::NoSigintHandler | ros::init_options::NoRosout);
        if (isSimulated) ros::param::set("/use_sim_time", true);
        ros::start();
        node_ = std::make_unique<ros::NodeHandle>();
        clock_ = node_->advertise<rosgraph_msgs::Clock>("/clock", 10);
    }
    void publish(nsecs time) {
        rosgraph_msgs::Clock message;
        message.clock = rosTime(time);
        clock_.publish(message);
    }
    /// Waits until the simulation has that time: no message is replaced by the next one.
    void publishAndWait(nsecs time) {
        publish(time);
        ASSERT_TRUE(eventually([&] { return simulated() == time; })) << simulated() << " instead of " << time;
    }
    void enable() {
        ASSERT_TRUE(use_ros_clock_topic());
        ASSERT_TRUE(enable_sim());
        ASSERT_TRUE(eventually([&] { return clock_.getNumSubscribers() == 1; }));
    }
    ~ClockTopicTest() override {
        EXPECT_TRUE(disable_sim());
        clock_.shutdown();
        node_.reset();
        if (ros::isStarted()) ros::shutdown();
    }

    RosMaster master;
    std::unique_ptr<ros::NodeHandle> node_;
    ros::Publisher clock_;
};

TEST_F(ClockTopicTest, NeedsANodeAndTheParameter) {
    ASSERT_TRUE(use_ros_clock_topic());
    EXPECT_FALSE(enable_sim());
    beNode(false);
    EXPECT_FALSE(enable_sim());
    ros::param::set("/use_sim_time", false);
    EXPECT_FALSE(enable_sim());
    ros::param::set("/use_sim_time", 1);
    EXPECT_FALSE(enable_sim());
    ros::param::set("/use_sim_time", true);
    EXPECT_TRUE(enable_sim());
    EXPECT_FALSE(update_sim_clock(ros::Time(1)));
    EXPECT_FALSE(use_manual_clock());
    EXPECT_TRUE(disable_sim());
    master.stop();
    EXPECT_FALSE(enable_sim());
    EXPECT_TRUE(use_manual_clock());
    EXPECT_TRUE(enable_sim());
}

TEST_F(ClockTopicTest, PeriodsAreExactOverTenThousandSteps) {
    beNode();
    Recorder fast, slow;
    SimClockActivity a(0.01, &fast), b(0.025, &slow);
    enable();
    ASSERT_TRUE(a.start() && b.start());
    // Faster than they are executed, so that some are replaced by later ones.
    for (nsecs step = 1; step <= 10000; ++step) {
        publish(step * 5 * kMs);
        if (step % 50 == 0) {
            ASSERT_TRUE(eventually([&] { return simulated() == step * 5 * kMs; }));
        }
    }
    ASSERT_TRUE(a.stop() && b.stop());
    ASSERT_EQ(fast.at.size(), 5000u);
    ASSERT_EQ(slow.at.size(), 2000u);
    for (std::size_t i = 0; i != fast.at.size(); ++i) ASSERT_EQ(fast.at[i], static_cast<nsecs>(i + 1) * 10 * kMs);
    for (std::size_t i = 0; i != slow.at.size(); ++i) ASSERT_EQ(slow.at[i], static_cast<nsecs>(i + 1) * 25 * kMs);
}

TEST_F(ClockTopicTest, PausesAndJumpsBack) {
    beNode();
    RTT::TaskContext c("c");
    c.setPeriod(0.01);
    ASSERT_TRUE(set_sim_clock_activity(&c));
    c.addOperation(
        "twice", [](int x) { return 2 * x; }, RTT::OwnThread);
    Recorder r;
    SimClockActivity a(0.01, &r);
    enable();
    ASSERT_TRUE(c.start() && a.start());
    publishAndWait(1000000 * kMs);  // enabled in the midst
    publishAndWait(1000010 * kMs);
    ASSERT_TRUE(eventually([&] { return host_now() == ros::Time(1000, 10000000); }));
    RTT::OperationCaller<int(int)> twice(c.getOperation("twice"), RTT::internal::GlobalEngine::Instance());
    EXPECT_EQ(twice(4), 8);  // the clock pauses
    publishAndWait(25 * kMs);
    publishAndWait(30 * kMs);
    publishAndWait(0);
    publishAndWait(10 * kMs);
    ASSERT_TRUE(a.stop());
    EXPECT_EQ(r.at, (std::vector<nsecs>{1000000 * kMs, 1000010 * kMs, 30 * kMs, 10 * kMs}));
    // Another time, and after the end of the node.
    ASSERT_TRUE(disable_sim());
    publish(35 * kMs);
    EXPECT_TRUE(RTT::os::TimeService::Instance()->systemClockEnabled());
    enable();
    ASSERT_TRUE(a.start());
    publishAndWait(40 * kMs);
    ASSERT_TRUE(a.stop());
    EXPECT_EQ(r.at.back(), 40 * kMs);
    ros::shutdown();
    EXPECT_TRUE(disable_sim());
    EXPECT_FALSE(enable_sim());
    c.stopForGood();
}

// At the end of the process, too, where the simulation is ended like this.
TEST_F(ClockTopicTest, AStoppedMasterHoldsNobodyUp) {
    beNode(false);
    ros::param::set("/use_sim_time", true);  // roscpp has no subscription of its own, so ours is the last one
    enable();
    publishAndWait(10 * kMs);
    master.send(SIGSTOP);
    usleep(100000);  // until all of its threads have stopped
    const auto begin = std::chrono::steady_clock::now();
    std::thread other([] { EXPECT_TRUE(disable_sim()); });
    EXPECT_TRUE(disable_sim());
    other.join();
    EXPECT_TRUE(RTT::os::TimeService::Instance()->systemClockEnabled());
    EXPECT_FALSE(enable_sim());
    EXPECT_TRUE(use_manual_clock());
    EXPECT_TRUE(enable_sim());
    EXPECT_TRUE(disable_sim());
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(6));
    master.send(SIGCONT);
    ASSERT_TRUE(use_ros_clock_topic());
    ASSERT_TRUE(eventually([] { return enable_sim(); }));
    ASSERT_TRUE(eventually([&] {
        publish(20 * kMs);
        return simulated() == 20 * kMs;
    }));
    EXPECT_TRUE(disable_sim());
    EXPECT_TRUE(eventually([&] { return clock_.getNumSubscribers() == 0; }));
}

// As plugin rosnode ends it: with a master that refuses connections.
TEST_F(ClockTopicTest, TheNodeEndsWhileTheMasterIsStopped) {
    beNode(false);
    ros::param::set("/use_sim_time", true);
    enable();
    master.send(SIGSTOP);
    usleep(100000);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE(disable_sim());
    ros::master::init({{"__master", "http://127.0.0.1:1/"}});
    ros::shutdown();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(6));
    master.send(SIGCONT);
}

}  // namespace
