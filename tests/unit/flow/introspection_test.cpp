// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Looking at connections: who is at the other end, with which policy, and what was lost.
#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/flow/storage_core.hpp>

#include <gtest/gtest.h>

#include <set>
#include <string>

using namespace RTT;

namespace {

typedef std::set<const base::PortInterface*> Ports;

Ports peersOf(const base::PortInterface& port) {
    Ports peers;
    for (const auto& channel : port.getManager()->getChannels()) peers.insert(channel.get<0>()->peer());
    return peers;
}

/** The ports that a tool finds which follows the links of the channels. */
Ports endsOf(const base::PortInterface& port, bool outputs) {
    Ports ends;
    for (const auto& channel : port.getManager()->getConnections())
        ends.insert(outputs ? channel.get<1>()->getOutputEndPoint()->getPort()
                            : channel.get<1>()->getInputEndPoint()->getPort());
    return ends;
}

struct Owner : TaskContext {
    explicit Owner(const std::string& name) : TaskContext(name) {
        addPort(in);
        addPort(out);
    }
    InputPort<int> in{"in"};
    OutputPort<int> out{"out"};
};

ConnPolicy owned(BufferPolicy owner) {
    ConnPolicy policy = ConnPolicy::buffer(3);
    policy.buffer_policy = owner;
    return policy;
}

}  // namespace

TEST(Introspection, ListsThePeersOfAPort) {
    for (const BufferPolicy owner : {PerConnection, PerInputPort, PerOutputPort}) {
        OutputPort<int> out1("out1"), out2("out2");
        InputPort<int> in1("in1"), in2("in2");
        for (InputPort<int>* in : {&in1, &in2})
            for (OutputPort<int>* out : {&out1, &out2}) ASSERT_TRUE(out->createConnection(*in, owned(owner)));
        EXPECT_EQ(peersOf(out1), (Ports{&in1, &in2}));
        EXPECT_EQ(peersOf(in2), (Ports{&out1, &out2}));
        in1.disconnect(&out1);
        EXPECT_EQ(peersOf(out1), (Ports{&in2}));
        EXPECT_EQ(peersOf(in1), (Ports{&out2}));
        EXPECT_EQ(out1.write(1), WriteSuccess);
        int got = 0;
        EXPECT_EQ(in1.read(got), NoData);
        EXPECT_EQ(in2.read(got), NewData);
    }
}

TEST(Introspection, LeadsFromTheChannelToTheComponentAtItsOtherEnd) {
    Owner source("source"), sink("sink");
    source.out.connectTo(&sink.in);
    const auto channels = source.out.getManager()->getChannels();
    ASSERT_EQ(channels.size(), 1u);
    EXPECT_EQ(channels.front().get<1>()->getOutputEndPoint()->getPort()->getInterface()->getOwner(), &sink);
    EXPECT_EQ(channels.front().get<1>()->getInputEndPoint()->getPort()->getInterface()->getOwner(), &source);
    EXPECT_NE(channels.front().get<0>()->toString(), "");
    EXPECT_EQ(channels.front().get<1>()->isRemoteElement(), false);
}

TEST(Introspection, FindsAPortAtBothEndsWhoeverOfTheOthersLeft) {
    for (const BufferPolicy owner : {PerConnection, PerInputPort, PerOutputPort, Shared}) {
        OutputPort<int> out1("out1"), out2("out2"), out3("out3");
        InputPort<int> in1("in1"), in2("in2"), in3("in3");
        ConnPolicy policy = owned(owner);
        for (InputPort<int>* in : {&in1, &in2, &in3})
            for (OutputPort<int>* out : {&out1, &out2, &out3}) ASSERT_TRUE(out->createConnection(*in, policy));
        out3.disconnect();
        in3.disconnect();
        out1.disconnect();
        in1.disconnect();
        EXPECT_EQ(endsOf(in2, false), (Ports{&out2})) << owner;
        EXPECT_EQ(endsOf(out2, true), (Ports{&in2})) << owner;
        EXPECT_FALSE(out1.connected() || out3.connected() || in1.connected() || in3.connected());
        out2.disconnect();
        EXPECT_EQ(in2.connected(), owner == Shared);
        if (owner == Shared) {
            EXPECT_EQ(endsOf(in2, true), (Ports{&in2}));
        }
    }
}

TEST(Introspection, CountsWhatWasLost) {
    OutputPort<int> out("out");
    InputPort<int> in("in");
    out.createConnection(in, ConnPolicy::buffer(2));
    for (int i = 0; i < 5; ++i) (void)out.write(i);
    internal::StorageCore* core = in.getManager()->getChannels().front().get<1>()->storageCore();
    ASSERT_TRUE(core);
    EXPECT_EQ(core->store().dropped(), 3u);
    EXPECT_EQ(core->store().size(), 2u);
    EXPECT_EQ(core->store().capacity(), 2u);
}

TEST(Introspection, IsASnapshot) {
    OutputPort<int> out("out");
    internal::ConnectionManager::Connections channels;
    {
        InputPort<int> in("in");
        out.connectTo(&in);
        channels = out.getManager()->getChannels();
    }
    ASSERT_EQ(channels.size(), 1u);
    EXPECT_EQ(channels.front().get<1>()->getOutputEndPoint()->getPort(), nullptr);
    EXPECT_TRUE(out.getManager()->getChannels().empty());
}
