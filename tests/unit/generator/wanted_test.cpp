// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/wanted.hpp>

#include <gtest/gtest.h>

namespace oroforge::merge {
namespace {

const diag::Location kHere{"m.xml", 1, 1};

std::vector<std::string> bodyOf(const std::string& hook) { return {"// " + hook}; }

model::Package packageOf(const model::Component& component) {
    model::Package package;
    package.components.push_back(component);
    package.components.back().className = {"tank::Plant", kHere};
    return package;
}

TEST(WantedClasses, HaveOperationsThenHooks) {
    model::Component component;
    model::Service gripper;
    gripper.name = {"gripper", kHere};
    model::Operation open;
    open.name = {"open", kHere};
    open.returns = {"bool", kHere};
    open.thread = model::Thread::Own;
    open.doc = "Lets\ngo";
    open.arguments.push_back({{"width", kHere}, {"double", kHere}, "m", "How \"far\"", kHere});
    gripper.operations.push_back(open);
    component.services.push_back(gripper);
    component.hooks = {false, true, false, true, false, true, false};

    const WantedClass plant = wantedClasses(packageOf(component), bodyOf).front();

    EXPECT_EQ(plant.name, "tank::Plant");
    EXPECT_EQ(plant.base, "tank::PlantBase");
    ASSERT_EQ(plant.methods.size(), 4u);
    const WantedMethod& method = plant.methods.front();
    EXPECT_EQ(method.name, "gripper_open");
    EXPECT_EQ(method.shown, "gripper.open");
    EXPECT_EQ(method.comment, (std::vector<std::string>{"Lets", "go"}));
    EXPECT_EQ(method.body, std::vector<std::string>{"return true;"});
    EXPECT_EQ(method.registrationText, "addOperation(\"open\", &Plant::gripper_open, this, RTT::OwnThread)");
    ASSERT_EQ(method.registration.texts.size(), 2u);
    EXPECT_EQ(method.registration.texts[0].words, "Lets go");
    EXPECT_EQ(method.registration.texts[1].argument, "width");
    EXPECT_EQ(method.registration.texts[1].words, "How \"far\" [m]");
    EXPECT_EQ(plant.methods[1].name, "startHook");
    EXPECT_EQ(plant.methods[1].signature.returns, "bool");
    EXPECT_EQ(plant.methods[1].body, std::vector<std::string>{"// start"});
    EXPECT_EQ(plant.methods[2].name, "errorHook");
    EXPECT_EQ(plant.methods[3].name, "stopHook");
}

TEST(WantedClasses, HaveMembersInTheOrderOfTheirKinds) {
    model::Component component;
    model::Attribute limit;
    limit.name = {"limit", kHere};
    limit.type = {"double", kHere};
    limit.defaultValue = {"2", kHere};
    limit.constant = true;
    limit.doc = "Most";
    component.attributes.push_back(limit);
    model::Port level;
    level.name = {"level", kHere};
    level.type = {"double", kHere};
    level.event = true;
    component.ports.push_back(level);

    const WantedClass plant = wantedClasses(packageOf(component), bodyOf).front();

    ASSERT_EQ(plant.members.size(), 2u);
    EXPECT_EQ(plant.members[0].registration.how, "addEventPort");
    EXPECT_EQ(plant.members[0].portClass, "InputPort");
    EXPECT_TRUE(plant.members[0].registration.texts.empty());
    EXPECT_EQ(plant.members[1].declared, "const double");
    EXPECT_EQ(plant.members[1].initialiser, " = 2.0");
    EXPECT_EQ(plant.members[1].comment, "Most");
    EXPECT_EQ(plant.members[1].registration.how, "addConstant");
    EXPECT_TRUE(plant.members[1].registration.texts.empty());
}

}  // namespace
}  // namespace oroforge::merge
