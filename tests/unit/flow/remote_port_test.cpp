// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Ports that stand for ones in another process, and ports that refuse a channel.
#include "log_capture.hpp"

#include <rtt/Port.hpp>

#include <gtest/gtest.h>

using namespace RTT;
using flow_test::LogCapture;

namespace {

constexpr int kProtocol = 77;

struct RemoteInput : InputPort<int> {
    RemoteInput() : InputPort<int>("far") {}
    int serverProtocol() const override { return kProtocol; }
};
struct RemoteOutput : OutputPort<int> {
    RemoteOutput() : OutputPort<int>("far") {}
    int serverProtocol() const override { return kProtocol; }
};
struct Reluctant : InputPort<int> {
    Reluctant() : InputPort<int>("reluctant") {}
    bool channelReady(base::ChannelElementBase::shared_ptr const&, ConnPolicy const&, internal::ConnID*) override {
        return false;
    }
};

}  // namespace

TEST(RemotePort, IsOneThatHasAProtocol) {
    EXPECT_FALSE(RemoteInput().isLocal());
    EXPECT_FALSE(RemoteOutput().isLocal());
    EXPECT_TRUE(InputPort<int>("near").isLocal());
    EXPECT_EQ(OutputPort<int>("near").serverProtocol(), 0);
}

TEST(RemotePort, IsNotWhereAConnectionStarts) {
    LogCapture log;
    RemoteOutput out;
    InputPort<int> in("in");
    EXPECT_FALSE(out.connectTo(&in));
    EXPECT_FALSE(in.connectTo(&out));
    EXPECT_FALSE(out.connected() || in.connected());
    EXPECT_TRUE(log.contains("output port far is a proxy")) << log.text();
}

TEST(RemotePort, NeedsATransportForItsType) {
    LogCapture log;
    OutputPort<int> out("out");
    RemoteInput in;
    EXPECT_FALSE(out.connectTo(&in));
    EXPECT_FALSE(out.connected() || in.connected());
    EXPECT_TRUE(log.contains("input port far lives in another process (protocol 77)")) << log.text();
}

TEST(RefusedChannel, LeavesNothingBehind) {
    for (const BufferPolicy where : {PerConnection, PerInputPort, PerOutputPort}) {
        LogCapture log;
        OutputPort<int> out("out");
        Reluctant in;
        ConnPolicy policy;
        policy.buffer_policy = where;
        EXPECT_FALSE(out.createConnection(in, policy));
        EXPECT_FALSE(out.connected() || in.connected());
        EXPECT_EQ(out.write(1), NotConnected);
        EXPECT_TRUE(log.contains("input port reluctant could not read from the connection with output port out"))
            << log.text();
    }
}
