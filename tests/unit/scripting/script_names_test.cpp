// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What dotted names find: variables, attributes, properties, peers, services, globals.
#include "script_fixture.hpp"

#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>

using namespace RTT;

namespace {

class Names : public ScriptTest {
protected:
    Names() : arm("arm") {
        component.addAttribute("speed", speed);
        component.addConstant("limit", limit);
        component.addProperty("gain", gain);
        component.addProperty("bag", bag);
        bag.ownProperty(new Property<double>("inner", "", 1.5));
        arm.addAttribute("speed", armSpeed);
        arm.provides("control")->addAttribute("stiffness", stiffness);
        component.connectPeers(&arm);
    }

    int speed = 3;
    int limit = 10;
    double gain = 0.5, armSpeed = 7, stiffness = 2;
    PropertyBag bag;
    TaskContext arm;
};

}  // namespace

TEST_F(Names, AttributesAndPropertiesOfTheComponent) {
    ASSERT_TRUE(run("speed = speed + 1\ngain = gain * speed\nthis.speed = this.speed * 10")) << messages();
    EXPECT_EQ(speed, 40);
    EXPECT_EQ(gain, 2.0);
}

TEST_F(Names, ConstantsCannotBeAssignedTo) {
    EXPECT_FALSE(run("limit = 3"));
    EXPECT_EQ(limit, 10);
    EXPECT_EQ(messages(), "script.ops:1:1: error: [OPS127] this is a constant or a result and cannot be assigned to\n");
}

TEST_F(Names, PeersAndServices) {
    ASSERT_TRUE(run("arm.speed = arm.control.stiffness + limit\narm.control.stiffness = 4.5")) << messages();
    EXPECT_EQ(armSpeed, 12);
    EXPECT_EQ(stiffness, 4.5);
}

TEST_F(Names, TheComponentItselfByName) {
    ASSERT_TRUE(run("robot.speed = 8\ntask.gain = 9")) << messages();
    EXPECT_EQ(speed, 8);
    EXPECT_EQ(gain, 9);
}

TEST_F(Names, EntriesOfBags) {
    ASSERT_TRUE(run("bag.inner = bag.inner * 2")) << messages();
    EXPECT_EQ(Property<double>(bag.find("inner")).get(), 3.0);
    EXPECT_FALSE(run("bag.iner = 1.0"));
    EXPECT_EQ(messages(),
              "script.ops:1:5: error: [OPS123] type PropertyBag has no member 'iner'; did you mean 'inner'?\n");
}

TEST_F(Names, TheSizeOfASequenceByAnotherName) {
    EXPECT_FALSE(run("var array a(3)\na[0] = a.length"));
    EXPECT_EQ(messages(), "script.ops:2:10: error: [OPS123] type array has no member 'length'; did you mean 'size'?\n");
}

TEST_F(Names, VariablesHideAttributes) {
    ASSERT_TRUE(run("var double speed = 1.5\nspeed = speed * 2")) << messages();
    EXPECT_EQ(speed, 3);
    EXPECT_EQ(value<double>("speed"), 3.0);
}

TEST_F(Names, Globals) {
    EXPECT_EQ(result<int>("int", "ORO_SCHED_OTHER"), 0);
    EXPECT_TRUE(run("var bool same = NewData == NewData")) << messages();
}

TEST_F(Names, UnknownOnes) {
    EXPECT_FALSE(run("sped = 1"));
    EXPECT_EQ(messages(),
              "script.ops:1:1: error: [OPS133] component 'robot' has no value or operation 'sped'; did you "
              "mean 'speed'?\n");
    EXPECT_FALSE(run("arm.contrl.stiffness = 1.0"));
    EXPECT_EQ(messages(),
              "script.ops:1:5: error: [OPS133] component 'arm' has no peer, service or value 'contrl'; did "
              "you mean 'control'?\n");
    EXPECT_FALSE(run("arm.control.stifness = 1.0"));
    EXPECT_EQ(messages(),
              "script.ops:1:13: error: [OPS133] service 'arm.control' has no value or operation "
              "'stifness'; did you mean 'stiffness'?\n");
    EXPECT_FALSE(run("var double d = arm.control"));
    EXPECT_EQ(messages(), "script.ops:1:16: error: [OPS132] 'arm.control' is a service, expected a value or a call\n");
}
