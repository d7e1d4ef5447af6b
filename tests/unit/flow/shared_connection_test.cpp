// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Shared connections as objects: made, named, found, joined and left.
#include "log_capture.hpp"

#include <rtt/Port.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/SharedConnection.hpp>

#include <gtest/gtest.h>

#include <string>

using namespace RTT;
using flow_test::LogCapture;
using internal::SharedConnectionBase;
using internal::SharedConnectionRepository;

namespace {
ConnPolicy shared(const std::string& name = "", int size = 3) {
    ConnPolicy policy = ConnPolicy::buffer(size);
    policy.buffer_policy = Shared;
    policy.name_id = name;
    return policy;
}
struct SharedPorts : testing::Test {
    OutputPort<int> out1{"out1"}, out2{"out2"};
    InputPort<int> in1{"in1"}, in2{"in2"};
    int got = 0;
};
}  // namespace

TEST_F(SharedPorts, JoinAConnectionObjectWithoutNamingAPeer) {
    ConnPolicy policy = shared("by object");
    ASSERT_TRUE(out1.createConnection(SharedConnectionBase::shared_ptr(), policy));  // makes it
    const SharedConnectionBase::shared_ptr connection = out1.getSharedConnection();
    ASSERT_TRUE(connection);
    EXPECT_EQ(connection->getName(), "by object");
    EXPECT_EQ(connection->getPolicy().size, 3);
    EXPECT_TRUE(in1.createConnection(connection));  // with its own policy
    EXPECT_TRUE(in2.createConnection(connection, policy));
    EXPECT_TRUE(out2.createConnection(connection));
    out1.write(1);
    out2.write(2);
    EXPECT_EQ(in1.read(got), NewData);
    EXPECT_EQ(got, 1);
    EXPECT_EQ(in2.read(got), NewData);
    EXPECT_EQ(got, 2);
    EXPECT_EQ(in1.read(got), NoData);
}

TEST_F(SharedPorts, RefuseToJoinNothing) {
    LogCapture log;
    EXPECT_FALSE(in1.createConnection(SharedConnectionBase::shared_ptr()));
    EXPECT_TRUE(log.contains("port in1: there is no shared connection to join")) << log.text();
}

TEST_F(SharedPorts, GetDifferentNamesIfTheyGiveNone) {
    ConnPolicy a = shared(), b = shared();
    ASSERT_TRUE(out1.createConnection(in1, a));
    ASSERT_TRUE(out2.createConnection(in2, b));
    EXPECT_NE(a.name_id, "");
    EXPECT_NE(a.name_id, b.name_id);
    EXPECT_EQ(out1.getSharedConnection()->getName(), a.name_id);
    EXPECT_EQ(SharedConnectionRepository::Instance().get(b.name_id), in2.getSharedConnection());
}

TEST_F(SharedPorts, ExtendTheConnectionTheyAreIn) {
    ASSERT_TRUE(out1.createConnection(in1, shared("pool")));
    ConnPolicy noName = shared();
    EXPECT_TRUE(out1.createConnection(in2, noName));
    EXPECT_EQ(noName.name_id, "pool");
    EXPECT_TRUE(out2.createConnection(in2, shared("pool")));
    EXPECT_EQ(out2.getSharedConnection(), in1.getSharedConnection());
    EXPECT_TRUE(out2.connectedTo(&in1));
    EXPECT_FALSE(in1.connectedTo(&in2));  // both read
    EXPECT_FALSE(in1.connectedTo(&in1));
    EXPECT_FALSE(in1.disconnect(&in2));
}

TEST_F(SharedPorts, CannotJoinTwo) {
    LogCapture log;
    ASSERT_TRUE(out1.createConnection(in1, shared("one")));
    ASSERT_TRUE(out2.createConnection(in2, shared("two")));
    EXPECT_FALSE(out1.createConnection(in2, shared()));
    EXPECT_FALSE(out1.createConnection(in2, shared("one")));
    EXPECT_TRUE(log.contains("a port of shared connection 'two' cannot also join 'one'")) << log.text();
    EXPECT_FALSE(in1.createConnection(out2.getSharedConnection()));
    EXPECT_EQ(in1.getSharedConnection()->getName(), "one");
}

TEST_F(SharedPorts, AgreeOnTypeSizeAndLock) {
    LogCapture log;
    ASSERT_TRUE(out1.createConnection(in1, shared("pool")));
    EXPECT_FALSE(out2.createConnection(in2, shared("pool", 4)));
    ConnPolicy other = shared("pool");
    other.lock_policy = ConnPolicy::LOCKED;
    EXPECT_FALSE(in2.createConnection(in1.getSharedConnection(), other));
    other = shared("pool");
    other.type = ConnPolicy::CIRCULAR_BUFFER;
    EXPECT_FALSE(out1.createConnection(in2, other));
    EXPECT_TRUE(log.contains("incompatible connection policies for shared connection 'pool'")) << log.text();
    EXPECT_FALSE(in2.connected() || out2.connected());
}

TEST_F(SharedPorts, LeaveWithoutEndingItForOthers) {
    ASSERT_TRUE(out1.createConnection(in1, shared("pool")));
    ASSERT_TRUE(out1.createConnection(in2, shared("pool")));
    EXPECT_TRUE(in1.disconnect(&out1));
    EXPECT_FALSE(in1.connected());
    EXPECT_TRUE(out1.connectedTo(&in2));
    EXPECT_EQ(out1.write(1), WriteSuccess);
    EXPECT_EQ(in2.read(got), NewData);
    out1.disconnect();
    in2.disconnect();
    EXPECT_FALSE(SharedConnectionRepository::Instance().get("pool"));
}

TEST_F(SharedPorts, KeepTheConnectionAliveWhileSomebodyHoldsIt) {
    SharedConnectionBase::shared_ptr held;
    ASSERT_TRUE(out1.createConnection(in1, shared("held")));
    held = in1.getSharedConnection();
    out1.write(4);
    out1.disconnect();
    in1.disconnect();
    EXPECT_EQ(SharedConnectionRepository::Instance().get("held"), held);
    ASSERT_TRUE(in2.createConnection(held));
    EXPECT_EQ(in2.read(got), NewData);  // what was in it still is
    EXPECT_EQ(got, 4);
}

TEST_F(SharedPorts, ShowTheConnectionAsTheirOnlyOne) {
    ASSERT_TRUE(out1.createConnection(in1, shared("shown")));
    ASSERT_TRUE(out1.createConnection(in2, shared("shown")));
    const auto channels = out1.getManager()->getChannels();
    ASSERT_EQ(channels.size(), 1u);
    EXPECT_EQ(channels.front().get<0>()->toString().find("shown") == std::string::npos, false);
    EXPECT_EQ(channels.front().get<2>().name_id, "shown");
    EXPECT_EQ(channels.front().get<2>().buffer_policy, Shared);
    EXPECT_EQ(channels.front().get<1>(), out1.getSharedConnection()->storage());
}

TEST_F(SharedPorts, AreNotMixedWithOtherConnections) {
    LogCapture log;
    ASSERT_TRUE(out1.createConnection(in1, ConnPolicy::buffer(3)));
    EXPECT_FALSE(out1.createConnection(in2, shared("mix")));
    EXPECT_FALSE(out2.createConnection(in1, shared("mix")));
    EXPECT_TRUE(log.contains("it already has another connection")) << log.text();
    EXPECT_FALSE(in2.connected() || out2.connected());
    EXPECT_FALSE(SharedConnectionRepository::Instance().get("mix"));
}
