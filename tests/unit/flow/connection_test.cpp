// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How connections are made, refused, looked at and broken.
#include "log_capture.hpp"

#include <rtt/Port.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/flow/reclaimer.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <string>

using namespace RTT;
using flow_test::LogCapture;

namespace {
struct Pair {
    OutputPort<int> out{"out"};
    InputPort<int> in{"in"};
    int got = 0;
    FlowStatus read() { return in.read(got); }
};
}  // namespace

TEST(Connection, WithInitBeginsWithTheLastWrittenValue) {
    Pair p;
    p.out.write(4);
    p.out.createConnection(p.in, ConnPolicy::data());
    EXPECT_EQ(p.read(), NewData);
    EXPECT_EQ(p.got, 4);
}

TEST(Connection, WithoutInitBeginsEmpty) {
    Pair p;
    p.out.write(4);
    p.out.createConnection(p.in, ConnPolicy::data(ConnPolicy::LOCK_FREE, false));
    EXPECT_EQ(p.read(), NoData);
}

TEST(Connection, WithInitBeginsEmptyIfNothingWasWritten) {
    Pair p;
    p.out.setDataSample(9);
    p.out.createConnection(p.in, ConnPolicy::data());
    EXPECT_EQ(p.read(), NoData);
}

TEST(Connection, UsesTheInputPortsPolicyIfNoneIsGiven) {
    OutputPort<int> out("out");
    InputPort<int> in("in", ConnPolicy::buffer(3));
    EXPECT_TRUE(in.connectTo(&out));
    for (int i = 0; i < 3; ++i) EXPECT_EQ(out.write(i), WriteSuccess);
    EXPECT_EQ(out.write(3), WriteFailure);
}

TEST(Connection, WorksWithEveryPolicy) {
    for (const int type : {ConnPolicy::DATA, ConnPolicy::BUFFER, ConnPolicy::CIRCULAR_BUFFER})
        for (const int lock : {ConnPolicy::UNSYNC, ConnPolicy::LOCKED, ConnPolicy::LOCK_FREE})
            for (const bool pull : {ConnPolicy::PUSH, ConnPolicy::PULL}) {
                Pair p;
                ConnPolicy policy(type, lock);
                policy.pull = pull;
                policy.size = 2;
                ASSERT_TRUE(p.out.createConnection(p.in, policy)) << policy;
                EXPECT_EQ(p.read(), NoData) << policy;
                EXPECT_EQ(p.out.write(1), WriteSuccess) << policy;
                EXPECT_EQ(p.read(), NewData) << policy;
                EXPECT_EQ(p.read(), OldData) << policy;
                EXPECT_EQ(p.got, 1) << policy;
            }
}

TEST(Connection, IsMadeByTheShortForms) {
    Pair a, b;
    EXPECT_TRUE(a.out.createDataConnection(a.in));
    EXPECT_TRUE(b.out.createBufferConnection(b.in, 2));
    b.out.write(1);
    b.out.write(2);
    EXPECT_EQ(b.read(), NewData);
    EXPECT_EQ(b.got, 1);
}

TEST(Connection, IsNotMadeTwice) {
    Pair p;
    EXPECT_TRUE(p.out.createConnection(p.in, ConnPolicy::buffer(2)));
    EXPECT_TRUE(p.out.createConnection(p.in, ConnPolicy::data()));
    EXPECT_EQ(p.out.getManager()->getConnections().size(), 1u);
    EXPECT_EQ(p.in.getManager()->getChannels().front().get<2>().type, ConnPolicy::BUFFER);
}

TEST(Connection, BetweenDifferentTypesIsRefusedNamingPortsAndTypes) {
    LogCapture log;
    OutputPort<double> out("thrust");
    InputPort<float> in("speed");
    EXPECT_FALSE(out.connectTo(&in));
    EXPECT_FALSE(in.connectTo(&out));
    EXPECT_FALSE(out.connected() || in.connected());
    EXPECT_TRUE(log.contains("output port thrust of type ")) << log.text();
    EXPECT_TRUE(log.contains(" is not compatible with input port speed of type ")) << log.text();
}

TEST(Connection, OfTwoPortsOfOneKindIsRefused) {
    LogCapture log;
    InputPort<int> a("a"), b("b");
    OutputPort<int> c("c"), d("d");
    EXPECT_FALSE(c.connectTo(&d));
    EXPECT_TRUE(log.contains("output port c could not connect to d: not an input port")) << log.text();
    EXPECT_FALSE(a.connectTo(&b));
    EXPECT_TRUE(log.contains("input port a could not connect to b: not an output port")) << log.text();
}

TEST(Connection, WithNothingIsRefused) {
    LogCapture log;
    InputPort<int> in("in");
    OutputPort<int> out("out");
    EXPECT_FALSE(out.connectTo(nullptr));
    EXPECT_FALSE(out.connectTo(nullptr, ConnPolicy::data()));
    EXPECT_TRUE(log.contains("output port out could not connect to nothing")) << log.text();
    EXPECT_FALSE(in.connectTo(nullptr));
    EXPECT_TRUE(log.contains("input port in could not connect to nothing")) << log.text();
}

TEST(Connection, WithAnInvalidPolicyIsRefused) {
    LogCapture log;
    Pair p;
    ConnPolicy policy;
    policy.type = 17;
    EXPECT_FALSE(p.out.createConnection(p.in, policy));
    policy = ConnPolicy(ConnPolicy::UNBUFFERED);
    EXPECT_FALSE(p.out.createConnection(p.in, policy));
    policy = ConnPolicy(ConnPolicy::DATA, 5);
    EXPECT_FALSE(p.out.createConnection(p.in, policy));
    EXPECT_FALSE(p.out.createConnection(p.in, ConnPolicy::buffer(-1)));
    EXPECT_FALSE(p.in.connected());
    EXPECT_TRUE(log.contains("invalid connection policy: unknown type")) << log.text();
    EXPECT_TRUE(
        log.contains("output port " + p.out.getFullName() + " is not connected to input port " + p.in.getFullName()))
        << log.text();
}

TEST(Connection, ThatIsNotMandatoryMayFail) {
    OutputPort<int> out("out");
    InputPort<int> must("must"), may("may");
    ConnPolicy policy = ConnPolicy::buffer(1);
    policy.mandatory = false;
    out.createConnection(may, policy);
    EXPECT_EQ(out.write(1), WriteSuccess);
    EXPECT_EQ(out.write(2), WriteSuccess);
    out.createConnection(must, ConnPolicy::buffer(1));
    EXPECT_EQ(out.write(3), WriteSuccess);
    EXPECT_EQ(out.write(4), WriteFailure);
}

TEST(Connection, OfBufferSizeZeroFailsAtEveryWrite) {
    LogCapture log;
    Pair p;
    EXPECT_TRUE(p.out.createConnection(p.in, ConnPolicy::buffer(0)));
    EXPECT_TRUE(log.contains("buffer of size 0")) << log.text();
    EXPECT_EQ(p.out.write(1), WriteFailure);
    EXPECT_EQ(p.read(), NoData);
}

TEST(Connection, IsBrokenFromEitherSide) {
    Pair p;
    for (int side = 0; side < 4; ++side) {
        ASSERT_TRUE(p.out.connectTo(&p.in));
        EXPECT_TRUE(p.out.connectedTo(&p.in) && p.in.connectedTo(&p.out));
        switch (side) {
            case 0: p.out.disconnect(); break;
            case 1: p.in.disconnect(); break;
            case 2: EXPECT_TRUE(p.out.disconnect(&p.in)); break;
            case 3: EXPECT_TRUE(p.in.disconnect(&p.out)); break;
        }
        EXPECT_FALSE(p.out.connected() || p.in.connected());
        EXPECT_FALSE(p.out.connectedTo(&p.in));
        EXPECT_EQ(p.out.write(1), NotConnected);
        EXPECT_EQ(p.read(), NoData);
    }
    EXPECT_FALSE(p.out.disconnect(&p.in));
    EXPECT_FALSE(p.in.disconnect(nullptr));
}

TEST(Connection, EndsOnlyWithTheNamedPeer) {
    OutputPort<int> out("out");
    InputPort<int> a("a"), b("b");
    out.connectTo(&a);
    out.connectTo(&b);
    EXPECT_TRUE(out.disconnect(&a));
    EXPECT_TRUE(out.connected() && b.connected());
    EXPECT_FALSE(a.connected());
    out.write(1);
    int got = 0;
    EXPECT_EQ(b.read(got), NewData);
}

TEST(Connection, EndsWithEitherPort) {
    OutputPort<int> out("out");
    {
        InputPort<int> in("in");
        out.connectTo(&in);
    }
    EXPECT_FALSE(out.connected());
    EXPECT_EQ(out.write(1), NotConnected);
    InputPort<int> in("in");
    {
        OutputPort<int> other("other");
        in.connectTo(&other);
        other.write(1);
    }
    EXPECT_FALSE(in.connected());
    EXPECT_EQ(internal::Reclaimer::pending(), 0u);
}

TEST(Connection, IsShownToThoseWhoAsk) {
    Pair p;
    p.out.createConnection(p.in, ConnPolicy::buffer(7, ConnPolicy::LOCKED));
    const auto connections = p.out.getManager()->getConnections();
    ASSERT_EQ(connections.size(), 1u);
    EXPECT_EQ(connections.front().get<0>()->peer(), &p.in);
    EXPECT_EQ(connections.front().get<2>().size, 7);
    EXPECT_EQ(connections.front().get<2>().lock_policy, ConnPolicy::LOCKED);
    const auto channel = connections.front().get<1>();
    EXPECT_EQ(channel->getInputEndPoint()->getPort(), &p.out);
    EXPECT_EQ(channel->getOutputEndPoint()->getPort(), &p.in);
    std::unique_ptr<internal::ConnID> id(p.in.getPortID());
    EXPECT_TRUE(p.out.removeConnection(id.get()));
    EXPECT_FALSE(p.in.connected());
}

TEST(Connections, AreReadInTurnUntilOneHasSomethingNew) {
    OutputPort<int> a("a"), b("b");
    InputPort<int> in("in");
    a.createConnection(in, ConnPolicy::buffer(5));
    b.createConnection(in, ConnPolicy::buffer(5));
    int got = 0;
    EXPECT_EQ(in.read(got), NoData);
    b.write(10);
    a.write(1);
    b.write(11);
    EXPECT_EQ(in.read(got), NewData);
    EXPECT_EQ(got, 1);  // first in the order of connecting
    EXPECT_EQ(in.read(got), NewData);
    EXPECT_EQ(got, 10);
    a.write(2);
    EXPECT_EQ(in.read(got), NewData);
    EXPECT_EQ(got, 11);  // the one that gave the last sample goes on
    EXPECT_EQ(in.read(got), NewData);
    EXPECT_EQ(got, 2);
    got = 0;
    EXPECT_EQ(in.read(got), OldData);
    EXPECT_EQ(got, 2);  // old data is that of the last one
    in.clear();
    EXPECT_EQ(in.read(got), NoData);
}

TEST(Connections, GiveOldDataOfAnotherOneWhenTheCurrentOneIsGone) {
    OutputPort<int> a("a"), b("b"), c("c");
    InputPort<int> in("in");
    a.createConnection(in);
    c.createConnection(in);
    b.createConnection(in);
    int got = 0;
    a.write(1);
    in.read(got);
    b.write(2);
    in.read(got);
    b.disconnect();
    EXPECT_EQ(in.read(got), OldData);
    EXPECT_EQ(got, 1);
}

TEST(Stream, WithoutTransportIsRefused) {
    LogCapture log;
    Pair p;
    EXPECT_FALSE(p.out.createStream(ConnPolicy()));
    EXPECT_FALSE(p.in.createStream(ConnPolicy()));
    EXPECT_TRUE(log.contains("need a transport for creating streams")) << log.text();
    EXPECT_FALSE(p.out.connected() || p.in.connected());
}
