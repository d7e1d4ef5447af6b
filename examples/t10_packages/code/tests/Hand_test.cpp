// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The hand is executed step by step; no time passes but that of the steps.
#include "Hand.hpp"

#include <gtest/gtest.h>

#include <rtt/extras/ComponentHarness.hpp>

namespace {

TEST(Hand, MovesAtItsSpeed) {
    gripper::Hand hand("hand");
    RTT::extras::ComponentHarness harness(hand, 0.1);
    auto& opening = harness.output<double>("opening");
    ASSERT_TRUE(harness.start());

    RTT::OperationCaller<bool(double)> moveTo(hand.provides("motion")->getOperation("moveTo"));
    ASSERT_TRUE(moveTo(0.02));
    harness.step(0.2);
    EXPECT_DOUBLE_EQ(opening.last(), 0.01);
    harness.step(1.0);
    EXPECT_DOUBLE_EQ(opening.last(), 0.02);
}

TEST(Hand, IsNotWiderThanItCanBe) {
    gripper::Hand hand("hand");
    EXPECT_FALSE(hand.motion_moveTo(0.3));
}

}  // namespace
