// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "added_services.hpp"
#include "message_script.hpp"

#include <geometry_msgs/PolygonStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/serialization.h>
#include <std_msgs/Float64MultiArray.h>
#include <std_msgs/Time.h>
#include <std_srvs/SetBool.h>

#include <rtt/encoding/Plan.hpp>

#include <geometry_msgs/typekit/Types.hpp>

#include <vector>

namespace ros_messages_test {
namespace {

class MessageTypekits : public ScriptTest {
protected:
    MessageTypekits() : ScriptTest("rtt_geometry_msgs") {}
};

/** The bytes of the encoding by shape, and those of roscpp. */
template <class M>
void expectSameBytes(const M& message, const std::string& type) {
    std::string why;
    const auto plan = RTT::encoding::Plan::make(*RTT::types::Types()->type(type), RTT::encoding::ros1Rules(), why);
    ASSERT_TRUE(plan) << why;
    const std::uint32_t size = ros::serialization::serializationLength(message);
    std::vector<std::uint8_t> expected(size), actual(plan->sizeOf(&message));
    ros::serialization::OStream stream(expected.data(), size);
    ros::serialization::serialize(stream, message);
    EXPECT_EQ(plan->encode(&message, actual.data(), actual.size()), size);
    EXPECT_EQ(actual, expected);
    M back;
    EXPECT_FALSE(plan->decode(actual.data(), actual.size(), RTT::encoding::ByteOrder::Little, &back));
    EXPECT_EQ(back, message);
}

TEST_F(MessageTypekits, bytesAreThoseOfRos) {
    geometry_msgs::PoseWithCovarianceStamped pose;
    pose.header.seq = 7;
    pose.header.stamp = ros::Time(1.25);
    pose.header.frame_id = "map";
    pose.pose.pose.orientation.w = 1;
    pose.pose.covariance[35] = 3;
    expectSameBytes(pose, "/geometry_msgs/PoseWithCovarianceStamped");
    geometry_msgs::PolygonStamped polygon;
    polygon.polygon.points.resize(3);
    polygon.polygon.points[2].z = 2.5f;
    expectSameBytes(polygon, "/geometry_msgs/PolygonStamped");
    std_msgs::Float64MultiArray array;
    array.layout.dim.resize(1);
    array.layout.dim[0].label = "x";
    array.data = {1, 2, 3};
    expectSameBytes(array, "/std_msgs/Float64MultiArray");
    std_msgs::Time time;
    time.data = ros::Time(3, 4);
    expectSameBytes(time, "/std_msgs/Time");
}

TEST_F(MessageTypekits, namesOfTypes) {
    for (const char* name :
         {"/geometry_msgs/Pose", "geometry_msgs.Pose", "/geometry_msgs/Pose[]", "/geometry_msgs/cPose[]",
          "/geometry_msgs/PoseArray", "geometry_msgs.Point32[]", "/std_msgs/Header", "std_msgs.Header[]"})
        EXPECT_TRUE(type(name)) << name;
    EXPECT_EQ(type("/geometry_msgs/Pose"), RTT::types::Types()->getTypeInfo<geometry_msgs::Pose>());
    EXPECT_EQ(type("/geometry_msgs/Pose[]"), RTT::types::Types()->getTypeInfo<std::vector<geometry_msgs::Pose>>());
    EXPECT_THAT(type("/geometry_msgs/PoseStamped")->getMemberNames(), testing::ElementsAre("header", "pose"));
}

TEST_F(MessageTypekits, whatIsNeededIsLoadedToo) {
    EXPECT_TRUE(RTT::types::TypekitRepository::hasTypekit("ros-primitives"));
    EXPECT_TRUE(RTT::types::TypekitRepository::hasTypekit("ros-std_msgs"));
    EXPECT_TRUE(RTT::types::TypekitRepository::hasTypekit("ros-geometry_msgs"));
    EXPECT_TRUE(RTT::types::TypekitRepository::hasTransport("rtt-ros-geometry_msgs-transport"));
}

TEST_F(MessageTypekits, membersFromScripts) {
    EXPECT_TRUE(
        eval("var geometry_msgs.PoseStamped p\n"
             "p.header.frame_id = \"world\"\n"
             "p.header.stamp = time(2.5)\n"
             "p.pose.position.x = 3.5\n"
             "text = p.header.frame_id\n"
             "number = p.pose.position.x\n"
             "count = p.header.stamp.nsec\n"));
    EXPECT_EQ(text, "world");
    EXPECT_EQ(number, 3.5);
    EXPECT_EQ(count, 500000000);
    EXPECT_TRUE(
        eval("var geometry_msgs.PoseWithCovariance c\n"
             "c.covariance[35] = 1.5\n"
             "number = c.covariance[35]\n"
             "count = c.covariance.size\n"));
    EXPECT_EQ(number, 1.5);
    EXPECT_EQ(count, 36);
    EXPECT_TRUE(
        eval("var geometry_msgs.Point[] points = geometry_msgs.Point[](3)\n"
             "points[1].y = 4.5\n"
             "number = points[1].y\n"));
    EXPECT_EQ(number, 4.5);
}

TEST_F(MessageTypekits, portsOfMessages) {
    RTT::OutputPort<geometry_msgs::Pose> out("out");
    RTT::InputPort<geometry_msgs::Pose> in("in");
    ASSERT_TRUE(out.connectTo(&in));
    geometry_msgs::Pose pose;
    pose.position.z = 2;
    out.write(pose);
    geometry_msgs::Pose got;
    ASSERT_EQ(in.read(got), RTT::NewData);
    EXPECT_EQ(got.position.z, 2);
}

TEST_F(MessageTypekits, servicesAndTheirTypes) {
    ASSERT_TRUE(RTT::plugin::PluginLoader::Instance()->loadPlugin("rtt_std_srvs"));
    ASSERT_EQ(addedServices().size(), 3u);
    EXPECT_STREQ(addedServices()[1].service, "std_srvs/SetBool");
    EXPECT_STREQ(addedServices()[1].md5, ros::service_traits::MD5Sum<std_srvs::SetBool>::value());
    EXPECT_STREQ(addedServices()[1].request, "/std_srvs/SetBoolRequest");
    EXPECT_EQ(type("/std_srvs/SetBoolResponse"), RTT::types::Types()->getTypeInfo<std_srvs::SetBool::Response>());
    EXPECT_TRUE(
        eval("var std_srvs.SetBoolResponse r\n"
             "r.message = \"done\"\n"
             "text = r.message\n"));
    EXPECT_EQ(text, "done");
}

}  // namespace
}  // namespace ros_messages_test
