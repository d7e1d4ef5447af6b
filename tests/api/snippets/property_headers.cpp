// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Properties.hpp>
#include <rtt/extras/Properties.hpp>

#include <gtest/gtest.h>

TEST(UserCode, FindsPropertiesUnderTheirOldHeaders) {
    RTT::PropertyBag bag;
    RTT::Property<double> property("gain", "", 2.0);
    bag.add(&property);
    EXPECT_EQ(bag.getProperty("gain"), &property);
}
