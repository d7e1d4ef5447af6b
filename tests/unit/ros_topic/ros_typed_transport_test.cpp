// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Transports that users write: for a type of theirs, and by the publish activity.
#include "node.hpp"

#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/types/TemplateTypeInfo.hpp>
#include <rtt_roscomm/rtt_rostopic_ros_msg_transporter.hpp>
#include <std_msgs/Float64.h>

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace {

/** Metres per second here, kilometres per hour in messages. */
struct Speed {
    double value = 0;
};
std::atomic<bool> mustThrow{false}, mustWait{false}, isWaiting{false};

}  // namespace

namespace rtt_roscomm {
template <>
struct RosMessageAdapter<Speed> {
    typedef Speed OrocosType;
    typedef std_msgs::Float64 RosType;
    static RosType toRos(const OrocosType& speed) {
        if (mustThrow) throw std::runtime_error("no message for this");
        isWaiting = mustWait.load();
        while (mustWait) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        RosType message;
        message.data = speed.value * 3.6;
        return message;
    }
    static OrocosType fromRos(const RosType& message) {
        Speed speed;
        speed.value = message.data / 3.6;
        return speed;
    }
};
}  // namespace rtt_roscomm

namespace {

using namespace rtt_roscomm;
using ros_test::soon;

void addType() {
    RTT::types::Types()->addType(new RTT::types::TemplateTypeInfo<Speed>("/Speed"));
    ASSERT_TRUE(RTT::types::Types()->type("/Speed")->addProtocol(ORO_ROS_PROTOCOL_ID, new RosMsgTransporter<Speed>()));
}

TEST(RosTypedTransport, TheAdapterMakesTheMessages) {
    const ros_test::Node node;
    addType();
    RTT::TaskContext component("c");
    RTT::OutputPort<Speed> out("out");
    RTT::InputPort<Speed> in("in");
    RTT::InputPort<double> seen("seen");
    component.addPort(out);
    component.addPort(in);
    component.addPort(seen);
    ASSERT_TRUE(out.createStream(topic("/speed")));
    ASSERT_TRUE(in.createStream(topic("/speed")));
    ASSERT_TRUE(seen.createStream(topic("/speed")));
    Speed speed, read;
    speed.value = 10;
    ASSERT_TRUE(soon([&] {
        out.write(speed);
        return in.read(read) == RTT::NewData;
    }));
    EXPECT_DOUBLE_EQ(10, read.value);
    double message = 0;
    ASSERT_TRUE(soon([&] { return seen.read(message) == RTT::NewData; }));
    EXPECT_DOUBLE_EQ(36, message);
    EXPECT_EQ("/speed", in.getManager()->getConnections().front().get<1>()->getInputEndPoint()->getRemoteURI());
    in.disconnect();
    out.disconnect();
    EXPECT_FALSE(in.connected());
}

TEST(RosTypedTransport, AnAdapterThatThrowsStopsNoTopic) {
    const ros_test::Node node;
    addType();
    RTT::TaskContext component("c");
    RTT::OutputPort<Speed> out("out");
    RTT::OutputPort<double> other("other");
    RTT::InputPort<double> in("in");
    component.addPort(out);
    component.addPort(other);
    component.addPort(in);
    ASSERT_TRUE(out.createStream(topic("/speed")));
    ASSERT_TRUE(other.createStream(topic("/other")));
    ASSERT_TRUE(in.createStream(topic("/other")));
    mustThrow = true;
    out.write(Speed());
    double value = 0;
    EXPECT_TRUE(soon([&] {
        other.write(1);
        return in.read(value) == RTT::NewData;
    }));
    mustThrow = false;
}

TEST(RosTypedTransport, ASlowAdapterDelaysNoOtherAfterTheFirstTime) {
    const ros_test::Node node;
    addType();
    RTT::TaskContext component("c");
    RTT::OutputPort<Speed> out("out");
    RTT::OutputPort<double> other("other");
    RTT::InputPort<Speed> seen("seen");
    RTT::InputPort<double> in("in");
    component.addPort(out);
    component.addPort(other);
    component.addPort(seen);
    component.addPort(in);
    ASSERT_TRUE(out.createStream(topic("/speed")));
    ASSERT_TRUE(seen.createStream(topic("/speed")));
    ASSERT_TRUE(other.createStream(topic("/other")));
    ASSERT_TRUE(in.createStream(topic("/other")));
    Speed speed;
    ASSERT_TRUE(soon([&] {
        out.write(speed);
        return seen.read(speed) == RTT::NewData;
    }));
    mustWait = true;
    out.write(Speed());
    ASSERT_TRUE(soon([] { return isWaiting.load(); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    mustWait = false;
    // The last one of the time before may still come.
    ASSERT_TRUE(soon([&] {
        double value = 0;
        other.write(0);
        return in.read(value) == RTT::NewData;
    }));
    mustWait = true;
    for (int i = 0; i != 20; ++i) {
        out.write(Speed());
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    double value = 0;
    EXPECT_TRUE(soon([&] {
        other.write(1);
        return in.read(value) == RTT::NewData;
    }));
    mustWait = false;
}

TEST(RosTypedTransport, PublishersOfUsersAreCalledByTheActivity) {
    struct Counter : RosPublisher {
        void publish() override { ++calls; }
        std::atomic<int> calls{0};
    } counter;
    const RosPublishActivity::shared_ptr activity = RosPublishActivity::Instance();
    activity->addPublisher(&counter);
    activity->addPublisher(&counter);
    EXPECT_EQ(ORO_SCHED_OTHER, activity->getScheduler());
    EXPECT_TRUE(activity->isActive());
    const int before = counter.calls;
    activity->trigger();
    EXPECT_TRUE(soon([&] { return counter.calls > before; }));
    activity->removePublisher(&counter);
    EXPECT_FALSE(activity->isActive());
    const int after = counter.calls;
    activity->trigger();
    EXPECT_EQ(after, counter.calls);
}

TEST(RosTypedTransport, APublisherRemovesItself) {
    struct Leaving : RosPublisher {
        void publish() override {
            RosPublishActivity::Instance()->removePublisher(this);
            hasLeft = true;
        }
        std::atomic<bool> hasLeft{false};
    } leaving;
    RosPublishActivity::Instance()->addPublisher(&leaving);
    RosPublishActivity::Instance()->trigger();
    EXPECT_TRUE(soon([&] { return leaving.hasLeft.load(); }));
}

}  // namespace
