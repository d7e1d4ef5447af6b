// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component rtt_tf::RTT_TF where something is missing or malformed, and in several threads.
#include "frames.hpp"

#include <flow/log_capture.hpp>

#include <ros/node_handle.h>
#include <ros/param.h>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <tf2_msgs/TFMessage.h>

#include <gmock/gmock.h>

#include <atomic>
#include <cmath>
#include <thread>

namespace {

using ros_test::moved;
using ros_test::soon;
using testing::HasSubstr;

class RosTfFaults : public ros_test::Frames {};

/** How often the text has the part. */
int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST_F(RosTfFaults, EachStepToAConfiguredComponentHasItsText) {
    flow_test::LogCapture log;
    for (int i = 0; i != 3; ++i) {
        EXPECT_TRUE(std::isnan(x("a", "b")));
        calls.broadcastTransform(moved("a", "b", 1));
    }
    EXPECT_FALSE(tf->configure());
    ros_test::addMessageTypes();
    for (const double bad : {0.0, -1.0, double(NAN), 1e10}) {
        set("cache_time", bad);
        EXPECT_FALSE(tf->configure());
    }
    set("cache_time", 10.0);
    for (const double bad : {0.0, double(NAN), 1e9}) {
        set("buffer_size", bad);
        EXPECT_FALSE(tf->configure());
    }
    const std::string text = log.finish();
    EXPECT_EQ(1, count(text, "no transform to 'a' from 'b': the component is not configured"));
    EXPECT_EQ(1, count(text, "cannot broadcast: call configure() first"));
    EXPECT_EQ(1, count(text, "import(\"rtt_tf2_msgs\") first"));
    EXPECT_EQ(4, count(text, "property cache_time is "));
    EXPECT_EQ(3, count(text, "property buffer_size is "));
    set("buffer_size", 1.0);
    EXPECT_TRUE(start());
}

TEST_F(RosTfFaults, WithoutMasterItIsNotConfigured) {
    ros_test::addMessageTypes();
    node.master().stop();
    flow_test::LogCapture log;
    EXPECT_FALSE(tf->configure());
    EXPECT_THAT(log.finish(), HasSubstr("tf: cannot be configured: the ROS master at"));
    ASSERT_TRUE(node.master().start());
    EXPECT_TRUE(start());
}

TEST_F(RosTfFaults, MissingTransformsAreExplainedOnceUntilTheyWork) {
    ros_test::addMessageTypes();
    ASSERT_TRUE(start());
    calls.broadcastStaticTransforms({moved("world", "base", 1), moved("other", "thing", 1)});
    ASSERT_TRUE(isAt(1, "other", "thing"));
    calls.broadcastTransform(moved("world", "arm", 1));
    ASSERT_TRUE(isAt(1, "world", "arm"));
    flow_test::LogCapture log;
    for (int i = 0; i != 3; ++i) {
        EXPECT_EQ("", calls.lookupTransform("world", "nowhere").header.frame_id);
        EXPECT_EQ("", calls.lookupTransform("world", "thing").header.frame_id);
        EXPECT_EQ("", calls.lookupTransformAtTime("world", "arm", ros::Time(5)).header.frame_id);
        EXPECT_EQ("", calls.lookupTransform("", "arm").header.frame_id);
        EXPECT_FALSE(calls.canTransform("world", "nobody"));
    }
    const std::string text = log.finish();
    EXPECT_EQ(1, count(text,
                       "to 'world' from 'nowhere': frame 'nowhere' is unknown; there are 'arm', 'base', 'other', "
                       "'thing', 'world'"))
        << text;
    EXPECT_EQ(1, count(text, "no transform to 'world' from 'thing': ")) << text;
    EXPECT_EQ(1, count(text, "no transform to 'world' from 'arm': ")) << text;
    EXPECT_EQ(1, count(text, "the name of a frame is empty"));
    EXPECT_EQ(0, count(text, "nobody"));
    EXPECT_EQ(1, x("world", "arm"));
    flow_test::LogCapture again;
    (void)calls.lookupTransformAtTime("world", "arm", ros::Time(5));
    EXPECT_THAT(again.finish(), HasSubstr("no transform to 'world' from 'arm': "));
}

TEST_F(RosTfFaults, MalformedTransformsAreNotBroadcast) {
    ros_test::addMessageTypes();
    ASSERT_TRUE(start());
    RTT::InputPort<tf2_msgs::TFMessage> sent("sent");
    ASSERT_TRUE(tf->getPort("tf_out")->connectTo(&sent, RTT::ConnPolicy::buffer(10)));
    flow_test::LogCapture log;
    geometry_msgs::TransformStamped zero = moved("world", "zero", 1);
    zero.transform.rotation.w = 0;
    for (int i = 0; i != 2; ++i) {
        calls.broadcastTransform(zero);
        calls.broadcastTransform(moved("world", "world", 1));
        calls.broadcastStaticTransform(moved("", "base", 1));
        calls.broadcastTransforms({moved("world", "nan", NAN), moved("world", "fine", 1)});
    }
    const std::string text = log.finish();
    EXPECT_EQ(1, count(text,
                       "tf: a transform is not broadcast: the transform from frame 'world' to frame 'zero' has a "
                       "rotation of length 0"));
    EXPECT_EQ(1, count(text, "has the same header.frame_id"));
    EXPECT_EQ(1, count(text, "has an empty header.frame_id"));
    EXPECT_EQ(1, count(text, "a value that is not finite"));
    tf2_msgs::TFMessage message;
    for (int i = 0; i != 2; ++i) {
        ASSERT_EQ(RTT::NewData, sent.read(message));
        ASSERT_EQ(1u, message.transforms.size());
        EXPECT_EQ("fine", message.transforms[0].child_frame_id);
    }
    EXPECT_NE(RTT::NewData, sent.read(message));
}

TEST_F(RosTfFaults, MalformedTransformsThatArriveAreIgnored) {
    ros_test::addMessageTypes();
    ASSERT_TRUE(start());
    flow_test::LogCapture log;
    ros::NodeHandle handle;
    ros::Publisher publisher = handle.advertise<tf2_msgs::TFMessage>("/tf", 10);
    ASSERT_TRUE(soon([&] { return publisher.getNumSubscribers() == 1; }));
    tf2_msgs::TFMessage message;
    message.transforms = {moved("world", "", 1), moved("world", "nan", NAN), moved("/world", "/base", 2)};
    for (int i = 0; i != 2; ++i) {
        message.transforms[2].header.stamp = ros::Time::now();
        publisher.publish(message);
        ASSERT_TRUE(soon([&] {
            const auto found = calls.lookupTransform("world", "base");
            return found.header.stamp == message.transforms[2].header.stamp;
        }));
    }
    EXPECT_TRUE(std::isnan(x("world", "nan")));
    for (int i = 0; i != 2; ++i) publisher.publish(message);
    EXPECT_TRUE(soon([&] { return log.contains("the transform to frame 'base' has the time of the one before"); }));
    const std::string text = log.finish();
    EXPECT_EQ(1, count(text, "tf: a received transform is ignored: a transform from frame 'world' has an empty child"));
    EXPECT_EQ(1, count(text, "a value that is not finite: translation nan 0 0"));
}

TEST_F(RosTfFaults, CleanupKeepsTheConnectionsOfOthers) {
    ros_test::addMessageTypes();
    RTT::OutputPort<tf2_msgs::TFMessage> feed("feed");
    ASSERT_TRUE(feed.connectTo(tf->getPort("tf_in"), RTT::ConnPolicy::buffer(10)));
    ASSERT_TRUE(start());
    ASSERT_TRUE(tf->stop() && tf->cleanup());
    EXPECT_TRUE(feed.connected());
    EXPECT_FALSE(tf->getPort("tf_out")->connected());
    EXPECT_FALSE(tf->getPort("tf_static_in")->connected());
    ASSERT_TRUE(start());
    tf2_msgs::TFMessage message;
    message.transforms = {moved("world", "base", 2)};
    feed.write(message);
    EXPECT_TRUE(isAt(2, "world", "base"));
}

int streamsOf(RTT::TaskContext& tf, const std::string& port) {
    return static_cast<int>(tf.getPort(port)->getManager()->getConnections().size());
}

TEST_F(RosTfFaults, ItIsConfiguredTwice) {
    ros_test::addMessageTypes();
    ASSERT_TRUE(tf->configure());
    ASSERT_TRUE(tf->configure());
    for (const char* port : {"tf_in", "tf_static_in", "tf_out", "tf_static_out"})
        EXPECT_EQ(1, streamsOf(*tf, port)) << port;
    ASSERT_TRUE(tf->start());
    calls.broadcastStaticTransform(moved("world", "base", 1));
    EXPECT_TRUE(isAt(1, "world", "base"));
    ASSERT_TRUE(tf->stop());
    set("buffer_size", double(NAN));
    EXPECT_FALSE(tf->configure());
    for (const char* port : {"tf_in", "tf_static_in", "tf_out", "tf_static_out"})
        EXPECT_EQ(0, streamsOf(*tf, port)) << port;
    EXPECT_TRUE(std::isnan(x("world", "base")));
}

TEST_F(RosTfFaults, APrefixMustBeAText) {
    ros_test::addMessageTypes();
    ros::param::set("/tf_prefix", 3);
    flow_test::LogCapture log;
    EXPECT_FALSE(tf->configure());
    EXPECT_EQ(1, count(log.finish(), "parameter /tf_prefix is no string; set it to a text"));
    ros::param::set("/tf_prefix", "robot1");
    EXPECT_TRUE(tf->configure());
}

TEST_F(RosTfFaults, BroadcastsGoOnWhileItIsConfigured) {
    ros_test::addMessageTypes();
    ASSERT_TRUE(start());
    std::atomic<bool> isOver{false};
    std::thread other([&] {
        for (int i = 0; !isOver; ++i)
            calls.broadcastStaticTransform(moved("world", "base" + std::to_string(i % 50), 1));
    });
    for (int round = 0; round != 10; ++round) EXPECT_TRUE(tf->stop() && tf->cleanup() && start());
    isOver = true;
    other.join();
}

TEST_F(RosTfFaults, ThreadsLookUpWhileItReceivesAndIsConfiguredAgain) {
    ros_test::addMessageTypes();
    RTT::OutputPort<tf2_msgs::TFMessage> feed("feed");
    ASSERT_TRUE(feed.connectTo(tf->getPort("tf_in"), RTT::ConnPolicy::buffer(100)));
    ASSERT_TRUE(start());
    std::atomic<bool> isOver{false};
    std::atomic<int> found{0};
    std::vector<std::thread> threads;
    for (int i = 0; i != 2; ++i)
        threads.emplace_back([&] {
            while (!isOver) found += calls.lookupTransform("world", "base").transform.translation.x == 1;
        });
    threads.emplace_back([&] {
        while (!isOver) calls.broadcastTransform(moved("base", "arm", 1));
    });
    ros::Time stamp = ros::Time::now();
    for (int round = 0; round != 3; ++round) {
        const int before = found;
        EXPECT_TRUE(soon([&] {
            tf2_msgs::TFMessage message;
            message.transforms = {moved("world", "base", 1, stamp += ros::Duration(0.001))};
            feed.write(message);
            return found > before + 100;
        }));
        EXPECT_TRUE(tf->stop() && tf->cleanup() && start());
    }
    isOver = true;
    for (std::thread& thread : threads) thread.join();
}

TEST_F(RosTfFaults, ALookupOutlivesTheComponent) {
    ros_test::addMessageTypes();
    ASSERT_TRUE(start());
    calls.broadcastStaticTransform(moved("world", "base", 1));
    ASSERT_TRUE(isAt(1, "world", "base"));
    std::atomic<bool> isOver{false};
    std::thread asks([&] {
        while (!isOver) {
            try {
                (void)calls.lookupTransform("world", "base");
            } catch (const std::exception&) {
                return;  // the operation has gone
            }
        }
    });
    RTT::ComponentLoader::Instance()->unloadComponent(tf);
    tf = nullptr;
    isOver = true;
    asks.join();
}

}  // namespace
