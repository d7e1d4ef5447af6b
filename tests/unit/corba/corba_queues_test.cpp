// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Ports of two processes, connected by their proxies, whose samples cross by message queues.
#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>

#include "../transports/raw_queue.hpp"
#include "peer_fixture.hpp"

#include <string>

using namespace RTT;
using corba_test::soon;
using transport_test::RawQueue;

namespace {

class CorbaQueues : public corba_test::PeerFixture {
protected:
    CorbaQueues() {
        here.addPort("out", out);
        here.addPort("in", in);
    }
    void SetUp() override {
        corba_test::PeerFixture::SetUp();
        startPeer();
    }
    void startPeer() {
        EXPECT_TRUE(peer->configure());
        EXPECT_TRUE(peer->start());
    }
    static ConnPolicy byQueue(const std::string& name = "") {
        ConnPolicy policy = ConnPolicy::buffer(10);
        policy.transport = 2;
        policy.name_id = name;
        return policy;
    }
    void connect(const ConnPolicy& there, const ConnPolicy& back) {
        ASSERT_TRUE(out.connectTo(peer->getPort("echo"), there));
        ASSERT_TRUE(peer->getPort("out")->connectTo(&in, back));
        EXPECT_EQ(there.name_id.substr(0, 1), "/") << "no queue";
        EXPECT_EQ(back.name_id.substr(0, 1), "/") << "no queue";
    }
    void expectSamplesCross(int count = 100) {
        double got = 0;
        for (int i = 1; i <= count; ++i) {
            ASSERT_EQ(out.write(i), WriteSuccess);
            ASSERT_TRUE(soon([&] { return in.read(got) == NewData; })) << i;
            EXPECT_EQ(got, 2 * i);
        }
    }
    bool areSeparate() {
        return !out.connected() && !in.connected() && !peer->getPort("echo")->connected() &&
               !peer->getPort("out")->connected();
    }
    TaskContext here{"here"};
    OutputPort<double> out;
    InputPort<double> in;
};

}  // namespace

TEST_F(CorbaQueues, CarrySamplesInBothDirections) {
    for (const int type : {ConnPolicy::DATA, ConnPolicy::BUFFER, ConnPolicy::CIRCULAR_BUFFER}) {
        for (const bool pull : {ConnPolicy::PUSH, ConnPolicy::PULL}) {
            SCOPED_TRACE(std::to_string(type) + (pull ? " pull" : " push"));
            ConnPolicy there = byQueue(), back = byQueue();
            there.type = back.type = type;
            there.pull = back.pull = pull;
            ASSERT_NO_FATAL_FAILURE(connect(there, back));
            EXPECT_TRUE(out.connectedTo(peer->getPort("echo")));
            EXPECT_TRUE(peer->getPort("out")->connectedTo(&in));
            EXPECT_TRUE(peer->getPort("echo")->connected());
            EXPECT_TRUE(out.connectTo(peer->getPort("echo"), byQueue())) << "once is enough";
            EXPECT_EQ(out.getManager()->getConnections().size(), 1U);
            ASSERT_NO_FATAL_FAILURE(expectSamplesCross());
            EXPECT_FALSE(RawQueue::exists(there.name_id) || RawQueue::exists(back.name_id)) << "both ends have it";
            // By the writer in this process, by the reader, and by the other process.
            if (type == ConnPolicy::DATA) {
                EXPECT_TRUE(out.disconnect(peer->getPort("echo")));
                EXPECT_TRUE(peer->getPort("out")->disconnect(&in));
            } else if (type == ConnPolicy::BUFFER) {
                out.disconnect();
                in.disconnect();
            } else {
                peer->getPort("echo")->disconnect();
                peer->getPort("out")->disconnect();
            }
            EXPECT_TRUE(soon([&] { return areSeparate(); }));
        }
    }
}

TEST_F(CorbaQueues, OfAGivenNameStayUntilTheWriterDisconnects) {
    const std::string there = transport_test::queueName("there"), back = transport_test::queueName("back");
    ASSERT_NO_FATAL_FAILURE(connect(byQueue(there), byQueue(back)));
    EXPECT_TRUE(RawQueue::exists(there) && RawQueue::exists(back)) << "others may look for them";
    expectSamplesCross();
    in.disconnect();
    peer->getPort("echo")->disconnect();
    EXPECT_TRUE(soon([&] { return areSeparate() && !RawQueue::exists(there) && !RawQueue::exists(back); }));
}

TEST_F(CorbaQueues, EndWithAKilledProcessAndReturnWithIt) {
    const ConnPolicy there = byQueue(), back = byQueue();
    ASSERT_NO_FATAL_FAILURE(connect(there, back));
    expectSamplesCross();
    end(SIGKILL);
    EXPECT_FALSE(RawQueue::exists(there.name_id) || RawQueue::exists(back.name_id));
    EXPECT_TRUE(soon([&] { return !peer->ready() && !out.connected() && !in.connected(); }));
    EXPECT_EQ(out.write(1), NotConnected);
    begin();
    EXPECT_TRUE(soon([&] { return peer->ready(); }));
    startPeer();
    EXPECT_TRUE(soon([&] { return out.connected() && in.connected(); }));
    expectSamplesCross();
    EXPECT_TRUE(out.connectedTo(peer->getPort("echo")));
}

TEST_F(CorbaQueues, AreNotMadeForOneThatCannotBeReached) {
    end(SIGKILL);
    const ConnPolicy policy = byQueue();
    EXPECT_FALSE(out.connectTo(peer->getPort("echo"), policy));
    EXPECT_FALSE(peer->getPort("out")->connectTo(&in, byQueue()));
    EXPECT_FALSE(out.connected() || in.connected());
    EXPECT_FALSE(RawQueue::exists(policy.name_id));
}
