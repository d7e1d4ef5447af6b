// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Attributes and constants as objects.
#include <rtt/RTT.hpp>

#include <gtest/gtest.h>

using namespace RTT;

TEST(ConfigurationMembers, AddingToAServiceGivesTheObject) {
    TaskContext component("component");
    double speed = 1;
    const int most = 7;
    Attribute<double>& made = component.provides()->addAttribute("speed", speed);
    made.set(2.5);
    EXPECT_EQ(2.5, speed);
    EXPECT_EQ(&made, component.getAttribute("speed"));
    Constant<int>& constant = component.provides()->addConstant("most", most);
    EXPECT_EQ(7, constant.get());
    EXPECT_EQ(&constant, component.getAttribute("most"));
    EXPECT_EQ(3.5, component.provides("limits")->addConstant("height", 3.5).get());
    EXPECT_EQ("height", component.provides("limits")->getValue("height")->getName());

    Attribute<int> own("old", 4);
    EXPECT_EQ(&own, &component.provides()->addAttribute("own", own));
    EXPECT_EQ("own", own.getName());
    Constant<int> fixed("old", 5);
    EXPECT_EQ(&fixed, &component.provides()->addConstant("fixed", fixed));
    EXPECT_TRUE(component.provides()->hasAttribute("own") && component.provides()->hasAttribute("fixed"));
}

TEST(ConfigurationMembers, AValueWithoutNameIsGivenButNotFound) {
    TaskContext component("component");
    double speed = 1;
    const std::size_t before = component.provides()->getAttributeNames().size();
    component.provides()->addAttribute("", speed).set(3);
    EXPECT_EQ(3, speed);
    EXPECT_EQ(before, component.provides()->getAttributeNames().size());
    EXPECT_FALSE(component.addAttribute("", speed));
}

TEST(ConfigurationMembers, TheComponentTellsWhetherItAdded) {
    TaskContext component("component");
    double speed = 1;
    Attribute<double> without_value;
    Constant<int> five("five", 5), nothing;
    EXPECT_TRUE(component.addAttribute("speed", speed));
    EXPECT_FALSE(component.addAttribute("nothing", without_value));
    EXPECT_TRUE(component.addConstant("speed2", speed));
    EXPECT_TRUE(component.addConstant("value", 3.5));
    EXPECT_TRUE(component.addConstant("five", five));
    EXPECT_FALSE(component.addConstant("nothing", nothing));
}

TEST(ConfigurationMembers, AConstantMayBeMadeEmptyAndBoundLater) {
    Constant<double> constant;
    EXPECT_FALSE(constant.ready());
    Constant<double> height("height", 1.75);
    constant = &height;
    ASSERT_TRUE(constant.ready());
    EXPECT_EQ(1.75, constant.get());
    EXPECT_EQ("height", constant.getName());
}
