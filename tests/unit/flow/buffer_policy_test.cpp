// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Storage that several connections share.
#include "log_capture.hpp"

#include <rtt/Port.hpp>
#include <rtt/internal/SharedConnection.hpp>

#include <gtest/gtest.h>

using namespace RTT;
using flow_test::LogCapture;

namespace {
ConnPolicy withPolicy(BufferPolicy buffer_policy, int size = 3) {
    ConnPolicy policy = ConnPolicy::buffer(size);
    policy.buffer_policy = buffer_policy;
    return policy;
}
struct Ports {
    OutputPort<int> out1{"out1"}, out2{"out2"};
    InputPort<int> in1{"in1"}, in2{"in2"};
    int got = 0;
};
}  // namespace

TEST(PerInputPort, FillsOneBufferFromAllWritersInOrder) {
    Ports p;
    ASSERT_TRUE(p.out1.createConnection(p.in1, withPolicy(PerInputPort)));
    ASSERT_TRUE(p.out2.createConnection(p.in1, withPolicy(PerInputPort)));
    p.out1.write(1);
    p.out2.write(2);
    p.out1.write(3);
    EXPECT_EQ(p.out2.write(4), WriteFailure);
    for (int i = 1; i <= 3; ++i) {
        EXPECT_EQ(p.in1.read(p.got), NewData);
        EXPECT_EQ(p.got, i);
    }
    EXPECT_EQ(p.in1.read(p.got), OldData);
    EXPECT_EQ(p.got, 3);
}

TEST(PerInputPort, KeepsTheOtherWritersWhenOneLeaves) {
    Ports p;
    p.out1.createConnection(p.in1, withPolicy(PerInputPort));
    p.out2.createConnection(p.in1, withPolicy(PerInputPort));
    p.out1.disconnect();
    EXPECT_FALSE(p.out1.connected());
    EXPECT_EQ(p.out2.write(2), WriteSuccess);
    EXPECT_EQ(p.in1.read(p.got), NewData);
    p.in1.disconnect();
    EXPECT_FALSE(p.out2.connected());
}

TEST(PerInputPort, RefusesAnotherStorage) {
    LogCapture log;
    Ports p;
    p.out1.createConnection(p.in1, withPolicy(PerInputPort));
    EXPECT_FALSE(p.out2.createConnection(p.in1, withPolicy(PerInputPort, 5)));
    EXPECT_TRUE(log.contains("incompatible connection policies for the shared buffer of port in1")) << log.text();
}

TEST(PerInputPort, DoesNotMixWithOrdinaryConnections) {
    LogCapture log;
    Ports p;
    p.out1.createConnection(p.in1, withPolicy(PerInputPort));
    EXPECT_FALSE(p.out2.createConnection(p.in1, ConnPolicy::data()));
    EXPECT_FALSE(p.out2.connected());
    EXPECT_TRUE(log.contains("already has connections with another buffer policy")) << log.text();
    Ports q;
    q.out1.createConnection(q.in1, ConnPolicy::data());
    EXPECT_FALSE(q.out2.createConnection(q.in1, withPolicy(PerInputPort)));
}

TEST(PerOutputPort, LetsReadersCompeteForSamples) {
    Ports p;
    ASSERT_TRUE(p.out1.createConnection(p.in1, withPolicy(PerOutputPort)));
    ASSERT_TRUE(p.out1.createConnection(p.in2, withPolicy(PerOutputPort)));
    p.out1.write(1);
    p.out1.write(2);
    EXPECT_EQ(p.in1.read(p.got), NewData);
    EXPECT_EQ(p.got, 1);
    EXPECT_EQ(p.in2.read(p.got), NewData);
    EXPECT_EQ(p.got, 2);
    EXPECT_EQ(p.in1.read(p.got), NoData);  // never old data
    EXPECT_EQ(p.in2.read(p.got), NoData);
}

TEST(PerOutputPort, IsEmptiedByClearOfTheOutputPort) {
    Ports p;
    p.out1.createConnection(p.in1, withPolicy(PerOutputPort));
    p.out1.write(1);
    p.out1.clear();
    EXPECT_EQ(p.in1.read(p.got), NoData);
}

TEST(SharedConnection, HasManyWritersAndReaders) {
    Ports p;
    ConnPolicy policy = withPolicy(Shared);
    ASSERT_TRUE(p.out1.createConnection(p.in1, policy));
    EXPECT_NE(policy.name_id, "");
    ASSERT_TRUE(p.out2.createConnection(p.in1, withPolicy(Shared)));
    ASSERT_TRUE(p.in2.createConnection(p.in1.getSharedConnection(), policy));
    p.out1.write(1);
    p.out2.write(2);
    EXPECT_EQ(p.in2.read(p.got), NewData);
    EXPECT_EQ(p.got, 1);
    EXPECT_EQ(p.in1.read(p.got), NewData);
    EXPECT_EQ(p.got, 2);
    EXPECT_EQ(p.in1.read(p.got), NoData);
    p.in1.disconnect();
    EXPECT_TRUE(p.out1.connected() && p.in2.connected());
    EXPECT_EQ(p.out1.write(3), WriteSuccess);
    EXPECT_EQ(p.in2.read(p.got), NewData);
}

TEST(SharedConnection, IsFoundByNameAndEndsWithItsLastPort) {
    ConnPolicy policy = withPolicy(Shared);
    policy.name_id = "pool";
    {
        Ports p;
        ASSERT_TRUE(p.out1.createConnection(p.in1, policy));
        ASSERT_TRUE(p.out2.createConnection(p.in2, policy));
        EXPECT_EQ(p.out1.getSharedConnection(), p.in2.getSharedConnection());
        EXPECT_TRUE(internal::SharedConnectionRepository::Instance().get("pool"));
    }
    EXPECT_FALSE(internal::SharedConnectionRepository::Instance().get("pool"));
}

TEST(SharedConnection, RefusesOtherTypesStoragesAndSecondConnections) {
    LogCapture log;
    Ports p;
    ConnPolicy policy = withPolicy(Shared), other = withPolicy(Shared);
    policy.name_id = "one";
    other.name_id = "two";
    ASSERT_TRUE(p.out1.createConnection(p.in1, policy));
    EXPECT_FALSE(p.out1.createConnection(p.in2, other));
    EXPECT_TRUE(log.contains("a port of shared connection 'one' cannot also join 'two'")) << log.text();
    ConnPolicy larger = withPolicy(Shared, 9);
    larger.name_id = "one";
    EXPECT_FALSE(p.out2.createConnection(p.in2, larger));
    OutputPort<double> doubles("doubles");
    InputPort<double> sink("sink");
    EXPECT_FALSE(doubles.createConnection(sink, policy));
    EXPECT_TRUE(log.contains("incompatible connection policies for shared connection 'one'")) << log.text();
    EXPECT_FALSE(p.out1.createConnection(p.in2, ConnPolicy::data()));
    EXPECT_FALSE(p.in2.connected() || p.out2.connected());
}
