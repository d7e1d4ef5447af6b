// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component that uses a type of such a typekit: what it needs is found in instantiations.cpp.
#include <rtt/RTT.hpp>
#include <rtt/base/ChannelElement.hpp>
#include "extern_templates.hpp"

#include <gtest/gtest.h>

#if !defined(ORO_PROPERTY_HPP) || !defined(ORO_INPUT_PORT_HPP) || !defined(ORO_OUTPUT_PORT_HPP) || \
    !defined(ORO_CORELIB_DATASOURCES_HPP) || !defined(ORO_CORELIB_ATTRIBUTE_HPP) ||                \
    !defined(CORELIB_DATASOURCE_HPP) || !defined(ORO_CHANNEL_ELEMENT_HPP)
#error "a guard that typekits ask for is missing"
#endif
#ifndef OROCOS_TARGET
#error "OROCOS_TARGET is missing"
#endif

using namespace RTT;

TEST(UserCode, UsesTemplatesThatATypekitInstantiates) {
    OutputPort<robot::Scan> out("out");
    InputPort<robot::Scan> in("in");
    ASSERT_TRUE(out.connectTo(&in));
    robot::Scan scan = robot::Scan();
    scan.points.resize(3);
    scan.padding[31] = 1.5f;
    out.setDataSample(scan);
    EXPECT_EQ(out.write(scan), WriteSuccess);
    robot::Scan seen = robot::Scan();
    EXPECT_EQ(in.read(seen), NewData);
    EXPECT_EQ(seen.points.size(), 3u);
    EXPECT_EQ(seen.padding[31], 1.5f);

    Property<robot::Scan> property("scan", "the last one", scan);
    EXPECT_EQ(property.rvalue().points.size(), 3u);
    Attribute<robot::Scan> attribute("scan", scan);
    attribute.set().points.clear();
    EXPECT_TRUE(attribute.get().points.empty());
    Constant<robot::Scan> constant("scan", scan);
    EXPECT_EQ(constant.get().points.size(), 3u);
    EXPECT_STREQ(OROCOS_TARGET_NAME, "gnulinux");
}
