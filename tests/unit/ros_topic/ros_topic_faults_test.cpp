// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Topics of names and types that do not fit, bytes that are no messages, masters that leave, and slow others.
#include "node.hpp"

#include "../flow/log_capture.hpp"

#include <ros/master.h>
#include <ros/node_handle.h>
#include <ros/topic_manager.h>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt_roscomm/rostopic.h>
#include <rtt_roscomm/rtt_rostopic_ros_publish_activity.hpp>
#include <std_msgs/Float64.h>
#include <std_msgs/String.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <mutex>
#include <thread>

namespace {

using namespace rtt_roscomm;
using flow_test::LogCapture;
using oroforge::test::RosMaster;
using ros_test::soon;
using testing::AllOf;
using testing::HasSubstr;

class RosTopicFaults : public testing::Test {
protected:
    ros_test::Node node;
    RTT::TaskContext component{"c"};
};

/** Each in a process of its own: what they do to the master shows in other cases. */
class RosTopicMaster : public RosTopicFaults {};

TEST_F(RosTopicFaults, PulledSamplesAreRefused) {
    RTT::OutputPort<double> out("out");
    component.addPort(out);
    RTT::ConnPolicy policy = topic("/t");
    policy.pull = true;
    LogCapture log;
    EXPECT_FALSE(out.createStream(policy));
    EXPECT_THAT(log.finish(), AllOf(HasSubstr("c.out"), HasSubstr("policy.pull")));
}

TEST_F(RosTopicFaults, ATypeWithoutATransportIsRefused) {
    RTT::OutputPort<char> out("out");
    component.addPort(out);
    LogCapture log;
    EXPECT_FALSE(out.createStream(topic("/t")));
    EXPECT_THAT(log.finish(),
                AllOf(HasSubstr("c.out"), HasSubstr("char"), HasSubstr("import rtt_roscomm and rtt_std_msgs")));
}

TEST_F(RosTopicFaults, AMessageWithoutATypekitNamesThePackage) {
    RTT::OutputPort<std_msgs::String> out("out");
    component.addPort(out);
    LogCapture log;
    EXPECT_FALSE(out.createStream(topic("/t")));
    EXPECT_THAT(log.finish(), HasSubstr("import rtt_roscomm and rtt_std_msgs"));
}

TEST_F(RosTopicFaults, NamesThatAreNoneAreRefused) {
    RTT::OutputPort<double> out("out");
    RTT::InputPort<double> in("in");
    component.addPort(out);
    component.addPort(in);
    for (const char* name : {"a b", "/a-b", "~", "~/", "/", "//", "1st", "a//~b"}) {
        LogCapture log;
        EXPECT_FALSE(out.createStream(topic(name))) << name;
        EXPECT_FALSE(in.createStream(topic(name))) << name;
        EXPECT_THAT(log.finish(), AllOf(HasSubstr("output port c.out"), HasSubstr("input port c.in"), HasSubstr(name)));
    }
    LogCapture log;
    EXPECT_FALSE(in.createStream(topic("")));
    EXPECT_FALSE(out.createStream(topic("~")));
    EXPECT_THAT(log.finish(), AllOf(HasSubstr("name_id is empty"), HasSubstr("name a topic in it, such as ~x")));
    EXPECT_FALSE(in.connected());
}

TEST_F(RosTopicFaults, AnotherTypeOfAnotherNodeIsAWarning) {
    XmlRpc::XmlRpcValue request, response, payload;
    request[0] = "/other";
    request[1] = "/t";
    request[2] = "std_msgs/String";
    request[3] = "http://127.0.0.1:1/";
    ASSERT_TRUE(ros::master::execute("registerPublisher", request, response, payload, false));
    RTT::InputPort<double> in("in");
    component.addPort(in);
    LogCapture log;
    EXPECT_TRUE(in.createStream(topic("/t")));
    EXPECT_THAT(log.finish(), AllOf(HasSubstr("/t"), HasSubstr("std_msgs/String"), HasSubstr("std_msgs/Float64")));
}

TEST_F(RosTopicFaults, AnotherTypeOfThisProcessIsRefused) {
    ros::NodeHandle handle;
    ros::Publisher other = handle.advertise<std_msgs::String>("/t", 1);
    RTT::InputPort<double> in("in");
    RTT::OutputPort<double> out("out");
    component.addPort(in);
    component.addPort(out);
    LogCapture log;
    EXPECT_FALSE(in.createStream(topic("t")));
    EXPECT_FALSE(out.createStream(topic("t")));
    EXPECT_THAT(log.finish(), AllOf(HasSubstr("c.in"), HasSubstr("c.out"), HasSubstr("publishes std_msgs/String"),
                                    HasSubstr("topic 't'")));
}

/** Publishes bytes of any kind as a message of any name. */
struct Bytes {
    std::vector<std::uint8_t> all;
};

}  // namespace

namespace ros {
namespace message_traits {
template <>
struct MD5Sum<Bytes> {
    static const char* value() { return MD5Sum<std_msgs::String>::value(); }
    static const char* value(const Bytes&) { return value(); }
};
template <>
struct DataType<Bytes> {
    static const char* value() { return "std_msgs/String"; }
    static const char* value(const Bytes&) { return value(); }
};
template <>
struct Definition<Bytes> {
    static const char* value() { return "string data"; }
    static const char* value(const Bytes&) { return value(); }
};
}  // namespace message_traits
namespace serialization {
template <>
struct Serializer<Bytes> {
    template <class Stream>
    static void write(Stream& stream, const Bytes& bytes) {
        std::uint8_t* const to = stream.advance(static_cast<std::uint32_t>(bytes.all.size()));
        std::copy(bytes.all.begin(), bytes.all.end(), to);
    }
    static std::uint32_t serializedLength(const Bytes& bytes) { return static_cast<std::uint32_t>(bytes.all.size()); }
};
}  // namespace serialization
}  // namespace ros

namespace {

TEST_F(RosTopicFaults, BytesThatAreNoMessageAreToldAndIgnored) {
    RTT::InputPort<std::string> in("in");
    component.addPort(in);
    ASSERT_TRUE(in.createStream(topicBuffer("/t", 10)));
    ros::NodeHandle handle;
    ros::Publisher publisher = handle.advertise<Bytes>("/t", 10);
    ASSERT_TRUE(soon([&] { return publisher.getNumSubscribers() == 1; }));
    LogCapture log;
    for (const Bytes& bytes : {Bytes{{}}, Bytes{{1, 0}}, Bytes{{255, 255, 255, 255}}, Bytes{{3, 0, 0, 0, 'a', 'b'}},
                               Bytes{{1, 0, 0, 0, 'a', 'b'}}, Bytes{{2, 0, 0, 0, 'o', 'k'}}})
        publisher.publish(bytes);
    std::string text;
    ASSERT_TRUE(soon([&] { return in.read(text) == RTT::NewData; }));
    EXPECT_EQ("ok", text);
    EXPECT_THAT(log.finish(),
                AllOf(HasSubstr("c.in"), HasSubstr("/tester"), HasSubstr("/t"), HasSubstr("std_msgs/String")));
}

TEST_F(RosTopicMaster, WithoutAMasterAStreamIsRefusedAtOnce) {
    RTT::OutputPort<double> out("out");
    component.addPort(out);
    node.master().stop();
    LogCapture log;
    EXPECT_FALSE(out.createStream(topic("/t")));
    EXPECT_THAT(log.finish(), AllOf(HasSubstr("master"), HasSubstr(node.master().uri())));
    ASSERT_TRUE(node.master().start());
    EXPECT_TRUE(out.createStream(topic("/t")));
}

TEST_F(RosTopicMaster, AMasterThatReturnsKnowsTheTopicsAgain) {
    RTT::OutputPort<double> out("out");
    RTT::InputPort<std::string> in("in");
    component.addPort(out);
    component.addPort(in);
    ASSERT_TRUE(out.createStream(topicLatched("/o")));
    ASSERT_TRUE(in.createStream(topic("/i")));
    out.write(5);
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    node.master().stop();
    ASSERT_TRUE(node.master().start());
    ASSERT_TRUE(soon([&] { return RosMaster::tool({"rostopic", "list"}).out.find("/o") != std::string::npos; }));
    EXPECT_EQ("data: 5.0\n---\n", RosMaster::tool({"rostopic", "echo", "-n", "1", "/o"}).out);
    const auto publisher = ros_test::publish("/i", "std_msgs/String", "back");
    std::string text;
    EXPECT_TRUE(soon([&] { return in.read(text) == RTT::NewData; }));
    EXPECT_EQ("back", text);
}

TEST_F(RosTopicMaster, AStoppedMasterHoldsNobodyUp) {
    RTT::OutputPort<double> first("first"), second("second"), third("third");
    RTT::InputPort<double> in("in");
    for (RTT::base::PortInterface* port : std::vector<RTT::base::PortInterface*>{&first, &second, &third, &in})
        component.addPort(*port);
    ASSERT_TRUE(first.createStream(topic("/first")));
    ASSERT_TRUE(second.createStream(topic("/second")));
    ASSERT_TRUE(third.createStream(topic("/third")));
    ASSERT_TRUE(in.createStream(topic("/third")));
    node.master().send(SIGSTOP);
    const auto begin = std::chrono::steady_clock::now();
    RTT::OutputPort<double> other("other");
    component.addPort(other);
    EXPECT_FALSE(other.createStream(topic("/u")));
    first.disconnect();
    second.disconnect();
    double value = 0;
    EXPECT_TRUE(soon([&] {
        third.write(7);
        return in.read(value) == RTT::NewData;
    }));
    in.disconnect();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(12));
    node.master().send(SIGCONT);
    EXPECT_TRUE(soon([&] { return RosMaster::tool({"rostopic", "list"}).out.find("/second") == std::string::npos; }));
}

TEST_F(RosTopicFaults, ASlowPublisherDelaysNoOther) {
    struct Slow : RosPublisher {
        void publish() override {
            isIn = true;
            while (!mayGo) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        std::atomic<bool> isIn{false}, mayGo{false};
    } slow;
    const RosPublishActivity::shared_ptr activity = RosPublishActivity::Instance();
    activity->addPublisher(&slow);
    activity->trigger();
    ASSERT_TRUE(soon([&] { return slow.isIn.load(); }));
    RTT::OutputPort<double> out("out");
    component.addPort(out);
    ASSERT_TRUE(out.createStream(topicLatched("/t")));
    std::atomic<int> received{0};
    ros::NodeHandle handle;
    ros::Subscriber subscriber =
        handle.subscribe<std_msgs::Float64>("/t", 1, [&](const std_msgs::Float64::ConstPtr&) { ++received; });
    out.write(1);
    EXPECT_TRUE(soon([&] { return received == 1; }));
    slow.mayGo = true;
    activity->removePublisher(&slow);
}

TEST_F(RosTopicFaults, AStreamIsClosedFromItsOwnCallback) {
    struct Closer : RTT::TaskContext {
        Closer() : TaskContext("closer") {
            addEventPort("in", in, [this](RTT::base::PortInterface*) {
                in.disconnect();
                isClosed = true;
            });
        }
        RTT::InputPort<double> in;
        std::atomic<bool> isClosed{false};
    } closer;
    ASSERT_TRUE(closer.start());
    ASSERT_TRUE(closer.in.createStream(topic("/t")));
    ros::NodeHandle handle;
    ros::Publisher publisher = handle.advertise<std_msgs::Float64>("/t", 1);
    ASSERT_TRUE(soon([&] { return publisher.getNumSubscribers() == 1; }));
    publisher.publish(std_msgs::Float64());
    EXPECT_TRUE(soon([&] { return closer.isClosed.load(); }));
    EXPECT_TRUE(soon([&] { return publisher.getNumSubscribers() == 0; }));
}

TEST_F(RosTopicFaults, ManyStreamsComeAndGoWhileOthersWrite) {
    RTT::OutputPort<double> out("out");
    RTT::InputPort<double> in("in");
    component.addPort(out);
    component.addPort(in);
    ASSERT_TRUE(in.createStream(topicBuffer("/t", 100)));
    std::atomic<bool> isOver{false};
    std::thread writer([&] {
        for (double i = 0; !isOver; ++i) out.write(i);
    });
    for (int i = 0; i != 100; ++i) {
        ASSERT_TRUE(out.createStream(topicBuffer("/t", 10)));
        RTT::InputPort<double> other("other");
        ASSERT_TRUE(other.createStream(topic("/t")));
        out.disconnect();
    }
    ASSERT_TRUE(out.createStream(topic("/t")));
    double value = 0;
    EXPECT_TRUE(soon([&] { return in.read(value) == RTT::NewData; }));
    isOver = true;
    writer.join();
}

}  // namespace
