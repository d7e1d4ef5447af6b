// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Vectors of numbers and rt_string over topics, against messages of roscpp, in both directions.
#include "topic_node.hpp"

#include <rtt/rt_string.hpp>
#include <rtt/types/GeneratedTypekit.hpp>

#include <std_msgs/Float32MultiArray.h>
#include <std_msgs/Float64MultiArray.h>
#include <std_msgs/Int16MultiArray.h>
#include <std_msgs/Int32MultiArray.h>
#include <std_msgs/Int64MultiArray.h>
#include <std_msgs/Int8MultiArray.h>
#include <std_msgs/String.h>
#include <std_msgs/UInt16MultiArray.h>
#include <std_msgs/UInt32MultiArray.h>
#include <std_msgs/UInt64MultiArray.h>
#include <std_msgs/UInt8MultiArray.h>

#include <limits>
#include <vector>

namespace ros_messages_test {
namespace {

class MultiArrayTopics : public TopicNode {
protected:
    template <class Message>
    void expectBothWays(const std::string& name) {
        SCOPED_TRACE(name);
        typedef typename Message::_data_type Vector;
        typedef typename Vector::value_type Number;
        ASSERT_EQ(RTT::types::Types()->type(name), RTT::types::Types()->getTypeInfo<Vector>());
        const Vector numbers = {std::numeric_limits<Number>::lowest(), 0, 7, std::numeric_limits<Number>::max()};
        RTT::OutputPort<Vector> out("out");
        RTT::InputPort<Vector> in("in");
        ASSERT_TRUE(out.createStream(topic("/from")));
        ASSERT_TRUE(in.createStream(topic("/to"))) << log.text();
        Listener<Message> listener("/from");
        ros::Publisher publisher = handle.advertise<Message>("/to", 10);
        ASSERT_TRUE(soon([&] { return listener.isConnected() && publisher.getNumSubscribers() != 0; }));
        out.write(numbers);
        ASSERT_TRUE(soon([&] { return listener.last().has_value(); }));
        const Message message = *listener.last();
        EXPECT_EQ(message.data, numbers);
        ASSERT_EQ(message.layout.dim.size(), 1u);
        EXPECT_EQ(message.layout.dim[0].size, 4u);
        EXPECT_EQ(message.layout.dim[0].stride, 4u);
        Message answer;
        answer.layout.dim.resize(2);
        answer.layout.dim[1].label = "x";
        answer.data = {3, 2, 1};
        publisher.publish(answer);
        Vector read;
        ASSERT_TRUE(soon([&] { return in.read(read) == RTT::NewData; }));
        EXPECT_EQ(read, answer.data);
    }

    ros::NodeHandle handle;
};

TEST_F(MultiArrayTopics, allTenVectorsInBothDirections) {
    import("rtt_std_msgs");
    expectBothWays<std_msgs::Int8MultiArray>("int8[]");
    expectBothWays<std_msgs::UInt8MultiArray>("uint8[]");
    expectBothWays<std_msgs::Int16MultiArray>("int16[]");
    expectBothWays<std_msgs::UInt16MultiArray>("uint16[]");
    expectBothWays<std_msgs::Int32MultiArray>("int32[]");
    expectBothWays<std_msgs::UInt32MultiArray>("uint32[]");
    expectBothWays<std_msgs::Int64MultiArray>("int64[]");
    expectBothWays<std_msgs::UInt64MultiArray>("uint64[]");
    expectBothWays<std_msgs::Float32MultiArray>("float32[]");
    expectBothWays<std_msgs::Float64MultiArray>("float64[]");
}

/** Typekits of users have their own names for vectors. */
TEST_F(MultiArrayTopics, aVectorThatHadAnotherNameBefore) {
    RTT::types::addType(RTT::types::makeSequenceType<std::vector<float>>("/std/vector</float>"));
    import("rtt_std_msgs");
    EXPECT_EQ(RTT::types::Types()->getTypeInfo<std::vector<float>>()->getTypeName(), "/std/vector</float>");
    expectBothWays<std_msgs::Float32MultiArray>("float32[]");
}

TEST_F(MultiArrayTopics, aRealTimeString) {
    import("rtt_std_msgs");
    RTT::OutputPort<RTT::rt_string> out("out");
    RTT::InputPort<RTT::rt_string> in("in");
    ASSERT_TRUE(out.createStream(topic("/from"))) << log.text();
    ASSERT_TRUE(in.createStream(topic("/to")));
    Listener<std_msgs::String> listener("/from");
    ros::Publisher publisher = handle.advertise<std_msgs::String>("/to", 10);
    ASSERT_TRUE(soon([&] { return listener.isConnected() && publisher.getNumSubscribers() != 0; }));
    out.write("from here");
    ASSERT_TRUE(soon([&] { return listener.last().has_value(); }));
    EXPECT_EQ(listener.last()->data, "from here");
    std_msgs::String answer;
    answer.data = "from there";
    publisher.publish(answer);
    RTT::rt_string read;
    ASSERT_TRUE(soon([&] { return in.read(read) == RTT::NewData; }));
    EXPECT_EQ(read, "from there");
}

}  // namespace
}  // namespace ros_messages_test
