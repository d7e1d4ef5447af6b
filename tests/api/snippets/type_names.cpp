// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Only the usual header: the names of the types of ports and properties.
#include <rtt/RTT.hpp>

#include <gtest/gtest.h>

TEST(UserCode, AsksPortsAndPropertiesForTheNameOfTheirType) {
    RTT::OutputPort<double> port("port");
    RTT::Property<double> property("property", "");
    const RTT::base::PortInterface& anyPort = port;
    const RTT::base::PropertyBase& anyProperty = property;
    ASSERT_NE(anyPort.getTypeInfo(), nullptr);
    EXPECT_EQ(anyPort.getTypeInfo(), anyProperty.getTypeInfo());
    EXPECT_EQ(anyPort.getTypeInfo()->getTypeName(), anyProperty.getType());
}
