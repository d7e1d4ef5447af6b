// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component rtt_tf::RTT_TF beside tf2_ros and the tools.
#include "frames.hpp"

#include <flow/log_capture.hpp>

#include <ros/node_handle.h>
#include <ros/param.h>
#include <rtt/InputPort.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <support/child_process.hpp>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

#include <gmock/gmock.h>

#include <cmath>

namespace {

using oroforge::test::ChildProcess;
using oroforge::test::Command;
using ros_test::moved;
using ros_test::soon;
using testing::HasSubstr;

Command program(const std::string& file, std::vector<std::string> arguments) {
    Command command;
    command.program = file;
    command.arguments = std::move(arguments);
    return command;
}

class RosTf : public ros_test::Frames {
protected:
    RosTf() {
        static const bool once = (ros_test::addMessageTypes(), true);
        (void)once;
    }
};

/** Each in a process of its own: what they set would show in other cases. */
class RosTfAlone : public RosTf {};

/** tf2_ros as other nodes use it. */
struct Listener {
    tf2_ros::Buffer buffer;
    tf2_ros::TransformListener listener{buffer};
    bool knows(const std::string& target, const std::string& source) {
        return soon([&] { return buffer.canTransform(target, source, ros::Time()); });
    }
};

TEST_F(RosTf, AStaticPublisherIsLookedUp) {
    EXPECT_TRUE(calls.ready());
    ASSERT_TRUE(start());
    EXPECT_FALSE(calls.canTransform("world", "base"));
    ChildProcess publisher(
        program("/usr/lib/tf2_ros/static_transform_publisher", {"1", "2", "3", "0", "0", "0", "1", "world", "base"}));
    ASSERT_TRUE(soon([&] { return calls.canTransform("world", "base"); }));
    const auto found = calls.lookupTransform("world", "base");
    EXPECT_EQ("world", found.header.frame_id);
    EXPECT_EQ("base", found.child_frame_id);
    EXPECT_EQ(3, found.transform.translation.z);
    EXPECT_EQ(-1, x("/base", "/world"));
    EXPECT_TRUE(calls.canTransformAtTime("world", "base", ros::Time(5)));
    EXPECT_EQ(2, calls.lookupTransformAtTime("world", "base", ros::Time(5)).transform.translation.y);
}

TEST_F(RosTf, BroadcastsReachOthersAndTheTools) {
    ASSERT_TRUE(start());
    Listener other;
    ChildProcess echo(program("/usr/lib/tf/tf_echo", {"world", "tool", "20"}));
    ASSERT_TRUE(soon([&] {
        calls.broadcastTransforms({moved("world", "base", 1), moved("base", "tool", 2)});
        return other.buffer.canTransform("world", "tool", ros::Time());
    }));
    EXPECT_EQ(3, other.buffer.lookupTransform("world", "tool", ros::Time()).transform.translation.x);
    EXPECT_TRUE(isAt(3, "world", "tool"));  // they come back by the topic
    EXPECT_TRUE(soon([&] {
        calls.broadcastTransforms({moved("world", "base", 1), moved("base", "tool", 2)});
        return echo.waitForOutput("Translation: [3.000, 0.000, 0.000]", std::chrono::milliseconds(50));
    }));
}

TEST_F(RosTf, ALateListenerHasAllStaticTransforms) {
    ASSERT_TRUE(start());
    calls.broadcastStaticTransform(moved("world", "base", 1));
    calls.broadcastStaticTransforms({moved("base", "arm", 2), moved("arm", "hand", 3)});
    calls.broadcastStaticTransform(moved("world", "base", 10));  // replaces the first
    ASSERT_TRUE(isAt(15, "world", "hand"));
    Listener late;
    ASSERT_TRUE(late.knows("world", "hand"));
    EXPECT_EQ(15, late.buffer.lookupTransform("world", "hand", ros::Time()).transform.translation.x);
}

TEST_F(RosTf, StaticTransformsThatCameBeforeTheStartCount) {
    ASSERT_TRUE(tf->configure());
    tf2_ros::StaticTransformBroadcaster before;
    before.sendTransform(moved("world", "base", 4));
    ASSERT_TRUE(tf->start());
    EXPECT_TRUE(isAt(4, "world", "base"));
    // Configured again, it learns them again.
    ASSERT_TRUE(tf->stop() && tf->cleanup() && start());
    EXPECT_TRUE(isAt(4, "world", "base"));
}

TEST_F(RosTfAlone, APrefixIsThePropertyOrAParameterSearchedUpward) {
    set<std::string>("tf_prefix", "mine");
    ASSERT_TRUE(start());
    calls.broadcastStaticTransform(moved("odom", "base", 1));
    EXPECT_TRUE(isAt(1, "mine/odom", "mine/base"));
    ASSERT_TRUE(tf->stop() && tf->cleanup());
    ros::param::set("/tf_prefix", "/robot1");
    ASSERT_TRUE(start());
    EXPECT_EQ("/robot1", static_cast<RTT::Property<std::string>*>(tf->getProperty("tf_prefix"))->get());
    calls.broadcastStaticTransforms({moved("odom", "base", 1), moved("/map", "odom", 2)});
    EXPECT_TRUE(isAt(3, "map", "robot1/base"));
    ASSERT_TRUE(tf->stop() && tf->cleanup());
    ros::param::set("~tf_prefix", "robot2");
    ASSERT_TRUE(start());
    calls.broadcastStaticTransform(moved("odom", "base", 1));
    EXPECT_TRUE(isAt(1, "robot2/odom", "robot2/base"));
    ASSERT_TRUE(tf->stop() && tf->cleanup());
    ros::param::set("~tf_prefix", 2);
    flow_test::LogCapture log;
    EXPECT_FALSE(tf->configure());
    EXPECT_THAT(log.finish(), HasSubstr("parameter /tester/tf_prefix is no string"));
}

TEST_F(RosTf, TrackersWriteAtEachUpdate) {
    ASSERT_TRUE(start());
    RTT::OperationCaller<bool(const std::string&, const std::string&)> subscribe(
        tf->provides("tf")->getOperation("subscribeTransform"), user.engine());
    EXPECT_TRUE(subscribe("world", "base"));
    EXPECT_TRUE(subscribe("/world", "base"));
    RTT::OperationCaller<std::string()> list(tf->getOperation("listTrackers"), user.engine());
    EXPECT_EQ("tracker_tf_base_world: to 'world' from 'base'\n", list());
    RTT::InputPort<geometry_msgs::TransformStamped> in("in");
    ASSERT_TRUE(tf->getPort("tracker_tf_base_world")->connectTo(&in, RTT::ConnPolicy::buffer(10)));
    tf2_ros::TransformBroadcaster other;
    geometry_msgs::TransformStamped got;
    for (const double x : {1.0, 2.0})
        ASSERT_TRUE(soon([&] {
            other.sendTransform(moved("world", "base", x));
            return in.read(got) == RTT::NewData && got.transform.translation.x == x;
        }));
    // Names that would meet are refused, as is an empty one.
    EXPECT_TRUE(subscribe("c", "a_b"));
    flow_test::LogCapture log;
    EXPECT_FALSE(subscribe("b_c", "a"));
    EXPECT_FALSE(subscribe("", "a"));
    const std::string text = log.finish();
    EXPECT_THAT(text, HasSubstr("there is another port or service 'tracker_tf_a_b_c'"));
    EXPECT_THAT(text, HasSubstr("the name of a frame is empty"));
}

TEST_F(RosTf, CacheTimeTakesEffect) {
    set("cache_time", 2.0);
    ASSERT_TRUE(start());
    const ros::Time now = ros::Time::now();
    for (const double age : {4.0, 3.0, 1.0, 0.0})
        calls.broadcastTransform(moved("world", "base", 10 - age, now - ros::Duration(age)));
    ASSERT_TRUE(isAt(10, "world", "base"));
    EXPECT_FALSE(calls.canTransformAtTime("world", "base", now - ros::Duration(3.5)));
    EXPECT_TRUE(calls.canTransformAtTime("world", "base", now - ros::Duration(0.5)));
    EXPECT_NEAR(9.5, calls.lookupTransformAtTime("world", "base", now - ros::Duration(0.5)).transform.translation.x,
                1e-6);
    ASSERT_TRUE(tf->stop() && tf->cleanup());
    set("cache_time", 20.0);
    ASSERT_TRUE(start());
    for (const double age : {15.0, 0.0}) calls.broadcastTransform(moved("world", "base", 10, now - ros::Duration(age)));
    EXPECT_TRUE(soon([&] { return calls.canTransformAtTime("world", "base", now - ros::Duration(14)); }));
}

TEST_F(RosTfAlone, AfterAJumpBackOfTimeOnlyStaticTransformsAreLeft) {
    ros::Time::setNow(ros::Time(1000));
    ASSERT_TRUE(start());
    calls.broadcastStaticTransform(moved("world", "base", 1));
    calls.broadcastTransform(moved("base", "arm", 2));
    ASSERT_TRUE(isAt(3, "world", "arm"));
    ros::Time::setNow(ros::Time(10));
    flow_test::LogCapture log;
    ASSERT_TRUE(soon([&] {
        tf->trigger();
        return !calls.canTransform("world", "arm");
    }));
    EXPECT_EQ(1, x("world", "base"));
    EXPECT_THAT(log.finish(), HasSubstr("time went back by 990 s"));
    calls.broadcastTransform(moved("base", "arm", 5));
    EXPECT_TRUE(isAt(6, "world", "arm"));
}

TEST_F(RosTf, ScriptsUseTransforms) {
    ASSERT_TRUE(RTT::plugin::PluginLoader::Instance()->loadLibrary(RTT_SCRIPTING_FILE));
    ASSERT_TRUE(start());
    calls.broadcastStaticTransform(moved("world", "base", 1));
    ASSERT_TRUE(isAt(1, "world", "base"));
    ASSERT_TRUE(tf->loadService("scripting"));
    RTT::OperationCaller<bool(const std::string&)> eval(tf->provides("scripting")->getOperation("eval"), user.engine());
    EXPECT_TRUE(
        eval("var geometry_msgs.TransformStamped t\n"
             "t = tf.lookupTransform(\"world\", \"base\")\n"
             "broadcastTransform(t)\n"
             "tf.subscribeTransform(\"world\", \"base\")\n"));
    EXPECT_TRUE(tf->getPort("tracker_tf_base_world"));
}

}  // namespace
