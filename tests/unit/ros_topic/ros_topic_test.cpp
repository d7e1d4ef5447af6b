// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Ports as publishers and subscribers of a real master, beside roscpp's own and the command-line tools.
#include "node.hpp"

#include <ros/node_handle.h>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt_roscomm/rostopic.h>
#include <std_msgs/Float64.h>
#include <std_msgs/Float64MultiArray.h>
#include <std_msgs/String.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

namespace {

using namespace rtt_roscomm;
using oroforge::test::RosMaster;
using ros_test::soon;
using testing::ElementsAre;
using testing::HasSubstr;

class RosTopic : public testing::Test {
protected:
    ros_test::Node node;
    RTT::TaskContext component{"c"};
};

/** What roscpp's own subscriber receives. */
template <class Message>
class Listener {
public:
    explicit Listener(const std::string& topic, unsigned size = 100)
        : subscriber_(node_.subscribe<Message>(topic, size, [this](const typename Message::ConstPtr& message) {
              const std::lock_guard<std::mutex> lock(mutex_);
              all_.push_back(*message);
          })) {}
    std::vector<Message> all() {
        const std::lock_guard<std::mutex> lock(mutex_);
        return all_;
    }
    bool isConnected() const { return subscriber_.getNumPublishers() != 0; }

private:
    ros::NodeHandle node_;
    std::mutex mutex_;
    std::vector<Message> all_;
    ros::Subscriber subscriber_;
};

TEST_F(RosTopic, ADoubleReachesASubscriberOfRoscpp) {
    RTT::OutputPort<double> out("out");
    component.addPort(out);
    ASSERT_TRUE(out.createStream(topic("/t")));
    Listener<std_msgs::Float64> listener("/t");
    ASSERT_TRUE(soon([&] { return listener.isConnected(); }));
    EXPECT_EQ(RTT::WriteSuccess, out.write(1.5));
    ASSERT_TRUE(soon([&] { return listener.all().size() == 1; }));
    EXPECT_EQ(1.5, listener.all()[0].data);
}

TEST_F(RosTopic, AMessageOfRoscppWakesTheComponentOfAnEventPort) {
    struct Counter : RTT::TaskContext {
        Counter() : TaskContext("counter") { addEventPort("in", in); }
        void updateHook() override {
            std::string text;
            if (in.read(text) == RTT::NewData) seen = text;
            ++updates;
        }
        RTT::InputPort<std::string> in;
        std::atomic<int> updates{0};
        std::string seen;
    } counter;
    ASSERT_TRUE(counter.start());
    ASSERT_TRUE(soon([&] { return counter.updates != 0; }));
    counter.updates = 0;
    ASSERT_TRUE(counter.in.createStream(topic("chat")));
    ros::NodeHandle handle;
    ros::Publisher publisher = handle.advertise<std_msgs::String>("/chat", 1);
    ASSERT_TRUE(soon([&] { return publisher.getNumSubscribers() == 1; }));
    std_msgs::String message;
    message.data = "hello";
    publisher.publish(message);
    EXPECT_TRUE(soon([&] { return counter.updates == 1; }));
    counter.stop();
    EXPECT_EQ("hello", counter.seen);
}

TEST_F(RosTopic, AnArrayIsAMultiArrayOfOneDimension) {
    RTT::OutputPort<std::vector<double>> out("out");
    RTT::InputPort<std::vector<double>> in("in");
    component.addPort(out);
    component.addPort(in);
    ASSERT_TRUE(out.createStream(topic("/a")));
    ASSERT_TRUE(in.createStream(topic("/a")));
    Listener<std_msgs::Float64MultiArray> listener("/a");
    ASSERT_TRUE(soon([&] { return listener.isConnected(); }));
    out.write({1, 2, 3});
    ASSERT_TRUE(soon([&] { return listener.all().size() == 1; }));
    const std_msgs::Float64MultiArray message = listener.all()[0];
    EXPECT_THAT(message.data, ElementsAre(1, 2, 3));
    ASSERT_EQ(1u, message.layout.dim.size());
    EXPECT_EQ("", message.layout.dim[0].label);
    EXPECT_EQ(3u, message.layout.dim[0].size);
    EXPECT_EQ(3u, message.layout.dim[0].stride);
    EXPECT_EQ(0u, message.layout.data_offset);
    std::vector<double> read;
    ASSERT_TRUE(soon([&] { return in.read(read) == RTT::NewData; }));
    EXPECT_THAT(read, ElementsAre(1, 2, 3));
}

TEST_F(RosTopic, TheToolsSeeTopicAndType) {
    RTT::OutputPort<bool> out("out");
    RTT::InputPort<int> in("in");
    component.addPort(out);
    component.addPort(in);
    ASSERT_TRUE(out.createStream(topicLatched("~flag")));
    ASSERT_TRUE(in.createStream(topic("old_name")));
    out.write(true);
    EXPECT_EQ("std_msgs/Bool\n", RosMaster::tool({"rostopic", "type", "/tester/flag"}).out);
    EXPECT_EQ("data: True\n---\n", RosMaster::tool({"rostopic", "echo", "-n", "1", "/tester/flag"}).out);
    const auto publisher = ros_test::publish("/new_name", "std_msgs/Int32", "7");
    int value = 0;
    EXPECT_TRUE(soon([&] { return in.read(value) == RTT::NewData; }));
    EXPECT_EQ(7, value);
    out.disconnect();
    EXPECT_THAT(RosMaster::tool({"rostopic", "list"}).out, Not(HasSubstr("/tester/flag")));
}

TEST_F(RosTopic, ALatchedSampleReachesThoseWhoComeLater) {
    RTT::OutputPort<double> out("out");
    component.addPort(out);
    ASSERT_TRUE(out.createStream(topicLatched("/l")));
    out.write(1);
    out.write(2);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    Listener<std_msgs::Float64> listener("/l");
    ASSERT_TRUE(soon([&] { return listener.all().size() == 1; }));
    EXPECT_EQ(2, listener.all()[0].data);
}

TEST_F(RosTopic, ABufferSendsAllOfABurst) {
    RTT::OutputPort<double> out("out");
    component.addPort(out);
    ASSERT_TRUE(out.createStream(topicBuffer("/b", 10)));
    Listener<std_msgs::Float64> listener("/b");
    ASSERT_TRUE(soon([&] { return listener.isConnected(); }));
    for (int i = 0; i != 10; ++i) ASSERT_EQ(RTT::WriteSuccess, out.write(i));
    ASSERT_TRUE(soon([&] { return listener.all().size() == 10; }));
    for (int i = 0; i != 10; ++i) EXPECT_EQ(i, listener.all()[i].data);
}

TEST_F(RosTopic, AnInputWithABufferKeepsABurst) {
    RTT::InputPort<double> in("in");
    component.addPort(in);
    ASSERT_TRUE(in.createStream(topicBuffer("/b", 10)));
    ros::NodeHandle handle;
    ros::Publisher publisher = handle.advertise<std_msgs::Float64>("/b", 10);
    ASSERT_TRUE(soon([&] { return publisher.getNumSubscribers() == 1; }));
    std_msgs::Float64 message;
    for (int i = 0; i != 10; ++i) {
        message.data = i;
        publisher.publish(message);
    }
    double value = -1;
    for (int i = 0; i != 10; ++i) {
        ASSERT_TRUE(soon([&] { return in.read(value) == RTT::NewData; }));
        EXPECT_EQ(i, value);
    }
}

TEST_F(RosTopic, AnUnbufferedSampleIsSentByTheWriter) {
    RTT::OutputPort<double> out("out");
    component.addPort(out);
    ASSERT_TRUE(out.createStream(topicUnbuffered("/u")));
    Listener<std_msgs::Float64> listener("/u");
    ASSERT_TRUE(soon([&] { return listener.isConnected(); }));
    EXPECT_EQ(RTT::WriteSuccess, out.write(4));
    EXPECT_TRUE(soon([&] { return listener.all().size() == 1; }));
}

TEST_F(RosTopic, ConnectedPortsBecomeStreamsOfOneTopic) {
    RTT::OutputPort<double> out("out-1");
    RTT::InputPort<double> in("in");
    component.addPort(out);
    component.addPort(in);
    RTT::ConnPolicy policy = topic("");
    ASSERT_TRUE(out.connectTo(&in, policy));
    double value = 0;
    EXPECT_TRUE(soon([&] {
        out.write(3);
        return in.read(value) == RTT::NewData;
    }));
    EXPECT_EQ(3, value);
    out.disconnect(&in);
    EXPECT_FALSE(in.connected());
}

}  // namespace
