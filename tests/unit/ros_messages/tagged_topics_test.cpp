// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Structs with the tag @ros in their header are messages, although their typekit knows nothing of ROS.
#include "topic_node.hpp"

#include "tagged_types.hpp"

#include <rtt/types/MessageNames.hpp>

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/PoseArray.h>

namespace ros_messages_test {
namespace {

using oroforge::test::RosMaster;

class TaggedTopics : public TopicNode {
protected:
    void expectPoses() {
        RTT::OutputPort<tagged::Hand> out("out");
        RTT::InputPort<tagged::Hand> in("in");
        ASSERT_TRUE(out.createStream(topic("/from"))) << log.text();
        ASSERT_TRUE(in.createStream(topic("/to")));
        Listener<geometry_msgs::Pose> listener("/from");
        ros::Publisher publisher = handle.advertise<geometry_msgs::Pose>("/to", 10);
        ASSERT_TRUE(soon([&] { return listener.isConnected() && publisher.getNumSubscribers() != 0; }));
        tagged::Hand hand;
        hand.place.z = 3;
        hand.rotation = {0, 0, 0, 1};
        out.write(hand);
        ASSERT_TRUE(soon([&] { return listener.last().has_value(); }));
        EXPECT_EQ(listener.last()->position.z, 3);
        EXPECT_EQ(listener.last()->orientation.w, 1);
        geometry_msgs::Pose pose;
        pose.position.x = 5;
        pose.orientation.y = 0.5;
        publisher.publish(pose);
        ASSERT_TRUE(soon([&] { return in.read(hand) == RTT::NewData; }));
        EXPECT_EQ(hand.place.x, 5);
        EXPECT_EQ(hand.rotation[1], 0.5);
    }

    ros::NodeHandle handle;
};

TEST_F(TaggedTopics, theTypekitComesFirst) {
    ASSERT_TRUE(loader->loadLibrary(TAGGED_TYPEKIT));
    EXPECT_FALSE(RTT::types::Types()->type("/tagged/Hand")->hasProtocol(3));
    import("rtt_roscomm");
    expectPoses();
}

TEST_F(TaggedTopics, theTypekitComesLast) {
    import("rtt_roscomm");
    ASSERT_TRUE(loader->loadLibrary(TAGGED_TYPEKIT));
    expectPoses();
}

TEST_F(TaggedTopics, theNameOfARegisteredTypeComesLast) {
    import("rtt_roscomm");
    ASSERT_TRUE(loader->loadLibrary(TAGGED_TYPEKIT));
    const RTT::types::MessageName* const pose = RTT::types::announcedMessage("/tagged/Hand");
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->message, "geometry_msgs/Pose");
    EXPECT_FALSE(RTT::types::Types()->type("/tagged/Vector")->hasProtocol(3));
    EXPECT_TRUE(RTT::types::announceMessage("/tagged/Vector", "geometry_msgs/Point", "4a842b65f413084dc2b10fb484ea7f17",
                                            "float64 x\nfloat64 y\nfloat64 z\n"));
    EXPECT_TRUE(RTT::types::Types()->type("/tagged/Vector")->hasProtocol(3));
}

TEST_F(TaggedTopics, theToolsSeeTheMessage) {
    ASSERT_TRUE(loader->loadLibrary(TAGGED_TYPEKIT));
    import("rtt_roscomm");
    RTT::OutputPort<tagged::Path> out("out");
    ASSERT_TRUE(out.createStream(topic("/path")));
    EXPECT_EQ("geometry_msgs/PoseArray\n", RosMaster::tool({"rostopic", "type", "/path"}).out);
    Listener<geometry_msgs::PoseArray> listener("/path");
    ASSERT_TRUE(soon([&] { return listener.isConnected(); }));
    tagged::Path path;
    path.head.frame = "map";
    path.head.stamp.seconds = 8;
    path.hands.resize(2);
    path.hands[1].place.y = 4;
    out.write(path);
    ASSERT_TRUE(soon([&] { return listener.last().has_value(); }));
    EXPECT_EQ(listener.last()->header.frame_id, "map");
    EXPECT_EQ(listener.last()->header.stamp, ros::Time(8));
    ASSERT_EQ(listener.last()->poses.size(), 2u);
    EXPECT_EQ(listener.last()->poses[1].position.y, 4);
}

}  // namespace
}  // namespace ros_messages_test
