// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Streams over message queues whose other end is in this process, or is the test itself.
#include "raw_queue.hpp"
#include "transport_fixture.hpp"

#include <rtt/TaskContext.hpp>
#include <rtt/transports/mqueue/MQLib.hpp>

#include "../flow/log_capture.hpp"

#include <string>
#include <vector>

using namespace RTT;
using flow_test::LogCapture;
using transport_test::queueName;
using transport_test::RawQueue;
using transport_test::readSoon;

namespace {

class MqueueStreams : public transport_test::WithTypes {
protected:
    MqueueStreams() {
        policy.transport = ORO_MQUEUE_PROTOCOL_ID;
        policy.name_id = queueName("stream");
    }
    ConnPolicy policy = ConnPolicy::buffer(4);
    OutputPort<double> out{"out"};
    InputPort<double> in{"in"};
    double got = 0;
};

}  // namespace

TEST_F(MqueueStreams, NeedTheOutputFirst) {
    LogCapture log;
    EXPECT_FALSE(in.createStream(policy));
    EXPECT_FALSE(in.connected());
    EXPECT_TRUE(log.contains("queue '" + policy.name_id + "' cannot be used: there is none within 500 ms"))
        << log.text();
    EXPECT_FALSE(RawQueue::exists(policy.name_id)) << "receivers make none";
    ASSERT_TRUE(out.createStream(policy));
    ASSERT_TRUE(in.createStream(policy));
    EXPECT_EQ(out.write(1.5), WriteSuccess);
    ASSERT_TRUE(readSoon(in, got));
    EXPECT_EQ(got, 1.5);
}

TEST_F(MqueueStreams, RefuseNamesThatNoQueueHas) {
    for (const std::string name : {"queue", "/", "/a/b", "/a/"}) {
        LogCapture log;
        policy.name_id = name;
        EXPECT_FALSE(out.createStream(policy));
        EXPECT_TRUE(log.contains("queue '" + name + "' cannot be used: the names of message queues begin with '/'"))
            << log.text();
        EXPECT_FALSE(in.createStream(policy));
    }
    LogCapture log;
    policy.name_id = "/" + std::string(300, 'x');
    EXPECT_FALSE(out.createStream(policy));
    EXPECT_TRUE(log.contains("its name is too long")) << log.text();
}

TEST_F(MqueueStreams, MakeANameFromThatOfTheComponent) {
    policy.name_id.clear();
    {
        LogCapture log;
        EXPECT_FALSE(out.createStream(policy));
        EXPECT_TRUE(log.contains("the port belongs to none")) << log.text();
    }
    TaskContext component("a/b");
    component.addPort(out);
    ASSERT_TRUE(out.createStream(policy));
    EXPECT_EQ(policy.name_id.find("/a_b.out."), 0U) << policy.name_id;
    EXPECT_NE(policy.name_id.find("@" + std::to_string(getpid())), std::string::npos);
    component.ports()->removePort("out");
}

TEST_F(MqueueStreams, RemoveTheQueueWithTheOutput) {
    ASSERT_TRUE(out.createStream(policy));
    EXPECT_TRUE(RawQueue::exists(policy.name_id));
    out.disconnect();
    EXPECT_FALSE(RawQueue::exists(policy.name_id));
}

TEST_F(MqueueStreams, HaveTheSizeOfThePolicy) {
    policy.size = 3;
    policy.data_size = 100;
    ASSERT_TRUE(out.createStream(policy));
    RawQueue queue(policy.name_id);
    EXPECT_EQ(queue.size().messages, 3);
    EXPECT_EQ(queue.size().bytes, 100);
    EXPECT_EQ(policy.data_size, 100);
}

TEST_F(MqueueStreams, AreAsLongAsTheSystemAllowsWithoutASize) {
    policy.size = 0;
    policy.type = ConnPolicy::DATA;
    ASSERT_TRUE(out.createStream(policy));
    EXPECT_EQ(RawQueue(policy.name_id).size().messages, 10);
    EXPECT_EQ(RawQueue(policy.name_id).size().bytes, 8);
}

TEST_F(MqueueStreams, RefuseAQueueWhoseMessagesAreTooSmall) {
    RawQueue small(policy.name_id, {10, 4});
    LogCapture log;
    EXPECT_FALSE(out.createStream(policy));
    EXPECT_TRUE(log.contains("it exists already, with messages of 4 bytes, and a sample needs 8")) << log.text();
}

TEST_F(MqueueStreams, TakeTheQueueOfAProcessThatEnded) {
    RawQueue old(policy.name_id, {10, 64});
    while (old.send("leftover")) continue;  // full
    policy.type = ConnPolicy::DATA;
    ASSERT_TRUE(out.createStream(policy));
    ASSERT_TRUE(in.createStream(policy));
    EXPECT_EQ(out.write(2), WriteSuccess);
    EXPECT_TRUE(transport_test::soon([&] { return in.read(got) != NoData && got == 2; }));
}

TEST_F(MqueueStreams, ReportAFullBuffer) {
    ASSERT_TRUE(out.createStream(policy));  // one place is taken by the first message
    for (int i = 0; i != 3; ++i) EXPECT_EQ(out.write(i), WriteSuccess);
    EXPECT_EQ(out.write(3), WriteFailure);
    RawQueue reader(policy.name_id);
    EXPECT_EQ(reader.receive().size(), 8U);
    EXPECT_EQ(out.write(4), WriteSuccess);
}

TEST_F(MqueueStreams, IgnoreMessagesOfAnotherSize) {
    ASSERT_TRUE(out.createStream(policy));
    ASSERT_TRUE(in.createStream(policy));
    RawQueue other(policy.name_id);
    LogCapture log;
    ASSERT_TRUE(other.send("abc"));
    ASSERT_TRUE(other.send("abc"));
    EXPECT_EQ(out.write(6), WriteSuccess);
    ASSERT_TRUE(readSoon(in, got));
    EXPECT_EQ(got, 6);
    const std::string text = log.finish();
    EXPECT_NE(text.find("is ignored: it has 3 bytes, expected 8"), std::string::npos) << text;
    EXPECT_EQ(text.find("is ignored"), text.rfind("is ignored")) << "reported once: " << text;
}

TEST_F(MqueueStreams, ReportASampleThatIsTooLarge) {
    OutputPort<std::string> text("text");
    policy.data_size = 2000;
    ASSERT_TRUE(text.createStream(policy));
    EXPECT_EQ(text.write(std::string(1900, 'x')), WriteSuccess);
    LogCapture log;
    EXPECT_EQ(text.write(std::string(5000, 'x')), WriteFailure);
    EXPECT_EQ(text.write(std::string(5000, 'x')), WriteFailure);
    EXPECT_TRUE(log.contains("a sample needs a message of 5013 bytes, and those of queue")) << log.text();
    EXPECT_EQ(log.text().find("needs a message"), log.text().rfind("needs a message")) << log.text();
}

TEST_F(MqueueStreams, KeepALargerSizeThanTheSample) {
    policy.data_size = 500;
    OutputPort<std::vector<double>> array("array");
    array.setDataSample(std::vector<double>(10));
    ASSERT_TRUE(array.createStream(policy));
    EXPECT_EQ(policy.data_size, 500);
    array.disconnect();
    policy.data_size = 0;
    ASSERT_TRUE(array.createStream(policy));
    EXPECT_EQ(policy.data_size, 88) << "as the original: 8 bytes, and ten numbers";
}

TEST_F(MqueueStreams, BeginWithAQueueWhoseSenderWaits) {
    ASSERT_TRUE(out.createStream(policy));
    (void)RawQueue(policy.name_id).receive();  // as an earlier receiver has
    ASSERT_TRUE(in.createStream(policy));
    EXPECT_EQ(in.read(got), NoData);
    EXPECT_EQ(out.write(5), WriteSuccess);
    ASSERT_TRUE(readSoon(in, got));
}

TEST_F(MqueueStreams, PassOverMessagesThatAreNoSamples) {
    RawQueue old(policy.name_id, {10, 16});
    ASSERT_TRUE(old.send("of another type"));
    ASSERT_TRUE(out.createStream(policy));
    LogCapture log;
    ASSERT_TRUE(in.createStream(policy));
    EXPECT_EQ(out.write(5), WriteSuccess);
    ASSERT_TRUE(readSoon(in, got));
    EXPECT_EQ(got, 5);
}

TEST_F(MqueueStreams, KeepTheNewestSampleOfAQueueForTwo) {
    policy = ConnPolicy::data();
    policy.transport = ORO_MQUEUE_PROTOCOL_ID;
    policy.name_id = queueName("two");
    policy.size = 1;
    ASSERT_TRUE(out.createStream(policy));
    for (int i = 1; i <= 5; ++i) EXPECT_EQ(out.write(i), WriteSuccess);
    ASSERT_TRUE(in.createStream(policy));
    EXPECT_TRUE(transport_test::soon([&] { return in.read(got) == NewData && got == 5; })) << got;
}

TEST_F(MqueueStreams, DoNotLoseSamplesToALaterDataSample) {
    ASSERT_TRUE(out.createStream(policy));
    for (int i = 1; i <= 3; ++i) ASSERT_EQ(out.write(i), WriteSuccess);
    out.setDataSample(7);
    ASSERT_TRUE(in.createStream(policy));
    for (int i = 1; i <= 3; ++i) {
        ASSERT_TRUE(readSoon(in, got)) << i;
        EXPECT_EQ(got, i);
    }
}

TEST_F(MqueueStreams, LeaveSamplesInTheQueueWhileTheBufferIsFull) {
    ConnPolicy small = policy;
    small.size = 2;
    ASSERT_TRUE(out.createStream(policy));
    ASSERT_TRUE(in.createStream(small));
    int accepted = 0;
    EXPECT_TRUE(transport_test::soon([&] {
        if (out.write(accepted + 1) == WriteSuccess) ++accepted;
        return accepted >= 7;  // two in the buffer, one on its way, four in the queue
    }));
    EXPECT_TRUE(transport_test::soon([&] { return out.write(99) == WriteFailure; })) << "the sender learns of it";
    for (int i = 1; i <= 7; ++i) {
        ASSERT_TRUE(readSoon(in, got)) << i;
        EXPECT_EQ(got, i);
    }
}

TEST_F(MqueueStreams, KeepAQueueThatSomebodyElseHasMade) {
    ASSERT_TRUE(out.createStream(policy));
    mq_unlink(policy.name_id.c_str());
    RawQueue other(policy.name_id, {10, 8});
    out.disconnect();
    EXPECT_TRUE(RawQueue::exists(policy.name_id));
}

TEST_F(MqueueStreams, RefuseAQueueThatIsTooSmallForWhatThePolicySays) {
    RawQueue small(policy.name_id, {10, 1024});
    OutputPort<std::string> text("text");
    policy.data_size = 4000;
    LogCapture log;
    EXPECT_FALSE(text.createStream(policy));
    EXPECT_TRUE(log.contains("with messages of 1024 bytes, and a sample needs 4000")) << log.text();
}

TEST_F(MqueueStreams, FollowASenderThatMadeTheQueueAnew) {
    if (access("/dev/mqueue", R_OK) != 0) GTEST_SKIP() << "/dev/mqueue is not mounted";
    ASSERT_TRUE(out.createStream(policy));
    ASSERT_TRUE(in.createStream(policy));
    for (int round = 1; round <= 20; ++round) {
        out.disconnect();
        ASSERT_TRUE(out.createStream(policy));
        ASSERT_EQ(out.write(round), WriteSuccess);
        ASSERT_TRUE(transport_test::soon([&] { return in.read(got) == NewData && got == round; })) << round;
    }
}
