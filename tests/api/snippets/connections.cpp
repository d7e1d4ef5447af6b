// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// As services do that draw what is connected.
#include <rtt/Port.hpp>

#include <gtest/gtest.h>

TEST(UserCode, ListsTheConnectionsOfAPort) {
    RTT::OutputPort<int> out("out");
    RTT::InputPort<int> in("in");
    ASSERT_TRUE(out.connectTo(&in));
    EXPECT_EQ(out.getManager()->getConnections().size(), 1u);
    EXPECT_EQ(in.getManager()->getConnections().size(), 1u);
}
