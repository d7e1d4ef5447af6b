// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Types described by tables: members, text, bags.
#include "builtin_typekit.hpp"
#include "sample_types.hpp"

#include <rtt/Property.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/types/PropertyDecomposition.hpp>

#include <memory>

using namespace RTT;
using namespace types_test;
using sample::Tank;

namespace {

class GeneratedTypes : public WithBuiltinTypes {
protected:
    static void SetUpTestSuite() {
        WithBuiltinTypes::SetUpTestSuite();
        sample::addTypes();
    }
    boost::intrusive_ptr<internal::ValueDataSource<Tank>> tank = variable(Tank());
    Tank& value = tank->set();
};

}  // namespace

TEST_F(GeneratedTypes, NamesAndDescription) {
    EXPECT_EQ("/sample/Tank", tank->getTypeName());
    EXPECT_EQ("a tank", tank->getTypeInfo()->getDescription());
    EXPECT_EQ(type("sample.Tank"), tank->getTypeInfo());
    EXPECT_EQ("array", type("std.vector<double>")->getTypeName()) << "the built-in name comes first";
    EXPECT_EQ(10u, tank->getMemberNames().size());
}

TEST_F(GeneratedTypes, MembersAreLive) {
    const SourcePtr id = tank->getMember("id");
    ASSERT_TRUE(id);
    value.id = 4;
    EXPECT_EQ(4, valueOf<int>(id));
    EXPECT_TRUE(id->update(variable(9).get()));
    EXPECT_EQ(9, value.id);
}

TEST_F(GeneratedTypes, MembersAreReachedByPath) {
    ASSERT_TRUE(tank->getMember("position.y")->update(variable(2.5).get()));
    EXPECT_EQ(2.5, value.position.y);
    value.path.resize(2);
    ASSERT_TRUE(tank->getMember("path.1.x")->update(variable(7.0).get()));
    EXPECT_EQ(7, value.path[1].x);
    EXPECT_EQ(nullptr, tank->getMember("nothing"));
    EXPECT_EQ(nullptr, tank->getMember("position.z"));
}

TEST_F(GeneratedTypes, MemberKeepsTheValueAlive) {
    SourcePtr member = tank->getMember("label");
    tank.reset();
    EXPECT_TRUE(member->update(variable("kept").get()));
    EXPECT_EQ("kept", valueOf<std::string>(member));
}

TEST_F(GeneratedTypes, MembersOfConstantsAreReadOnly) {
    value.position.x = 3;
    value.weights[2] = 5;
    const SourcePtr constant(new internal::ConstantDataSource<Tank>(value));
    const SourcePtr x = constant->getMember("position.x");
    ASSERT_TRUE(x);
    EXPECT_EQ(3, valueOf<double>(x));
    EXPECT_FALSE(x->isAssignable());
    EXPECT_FALSE(x->update(variable(1.0).get()));
    EXPECT_EQ(5, valueOf<double>(constant->getMember("weights.2")));
}

TEST_F(GeneratedTypes, ArraysHaveElementsButNoOtherSize) {
    ASSERT_TRUE(tank->getMember("weights.1")->update(variable(1.5).get()));
    EXPECT_EQ(1.5, value.weights[1]);
    EXPECT_EQ(3, valueOf<int>(tank->getMember("weights.size")));
    ASSERT_TRUE(tank->getMember("pair.1")->update(variable(8).get()));
    EXPECT_EQ(8, value.pair[1]);
    const SourcePtr weights = tank->getMember("weights");
    EXPECT_FALSE(weights->getTypeInfo()->resize(weights, 4));
}

TEST_F(GeneratedTypes, IndexMayBeASource) {
    value.levels = {1, 2, 3};
    auto index = variable(0);
    const SourcePtr element = tank->getMember("levels")->getMember(SourcePtr(index));
    EXPECT_EQ(1, valueOf<double>(element));
    index->set(2);
    EXPECT_EQ(3, valueOf<double>(element));
    EXPECT_TRUE(element->update(variable(9.0).get()));
    EXPECT_EQ(9, value.levels[2]);
}

TEST_F(GeneratedTypes, BeyondTheEndADefaultIsReadAndWritesAreLost) {
    value.levels = {1};
    const SourcePtr beyond = tank->getMember("levels.5");
    EXPECT_EQ(0, valueOf<double>(beyond));
    beyond->update(variable(4.0).get());
    EXPECT_EQ(0, valueOf<double>(beyond));
    EXPECT_EQ(std::vector<double>{1}, value.levels);
    EXPECT_EQ(0, valueOf<double>(tank->getMember("levels")->getMember(SourcePtr(variable(-1)))));
}

TEST_F(GeneratedTypes, SequencesResize) {
    const SourcePtr levels = tank->getMember("levels");
    EXPECT_TRUE(levels->getTypeInfo()->resize(levels, 4));
    EXPECT_EQ(4u, value.levels.size());
    EXPECT_EQ(4, valueOf<int>(levels->getMember("size")));
    EXPECT_FALSE(levels->getTypeInfo()->resize(levels, -1));
}

TEST_F(GeneratedTypes, PackedBitsAreReadAndWritten) {
    value.flags = {false, true};
    EXPECT_TRUE(valueOf<bool>(tank->getMember("flags.1")));
    ASSERT_TRUE(tank->getMember("flags.0")->update(variable(true).get()));
    EXPECT_TRUE(value.flags[0]);
}

TEST_F(GeneratedTypes, TextShowsAllMembers) {
    value.id = 3;
    value.label = "A";
    value.levels = {1, 2.5};
    value.mode = sample::Mode::Draining;
    value.small = 65;
    value.flags = {true};
    EXPECT_EQ(
        "{id = 3, label = A, position = {x = 0, y = 0}, levels = {1, 2.5}, path = {}, weights = {0, 0, 0}, "
        "pair = {0, 0}, mode = Draining, small = 65, flags = {true}}",
        tank->toString());
}

TEST_F(GeneratedTypes, EnumsAreReadByAnyName) {
    auto mode = variable(sample::Mode::Idle);
    const auto* info = mode->getTypeInfo();
    EXPECT_TRUE(info->fromString("Emptying", mode));
    EXPECT_EQ(sample::Mode::Draining, mode->get());
    EXPECT_EQ("Draining", info->toString(mode)) << "the first name of a value is its canonical one";
    EXPECT_TRUE(info->fromString("1", mode));
    EXPECT_EQ(sample::Mode::Filling, mode->get());
    EXPECT_FALSE(info->fromString("Nonsense", mode));
    mode->set(static_cast<sample::Mode>(3));
    EXPECT_EQ("3", info->toString(mode));
}

TEST_F(GeneratedTypes, EnumsConvertFromAndToInt) {
    EXPECT_EQ(sample::Mode::Filling, valueOf<sample::Mode>(type("sample.Mode")->convert(variable(1))));
    EXPECT_EQ(7, valueOf<int>(type("int")->convert(variable(sample::Mode::Draining))));
}

TEST_F(GeneratedTypes, BagRoundTripKeepsEveryField) {
    value.id = 3;
    value.label = "north <tank>";
    value.position.y = -0.5;
    value.levels = {1, 2};
    value.path = {{1, 2}, {3, 4}};
    value.weights[0] = 0.1;
    value.pair[1] = -7;
    value.mode = sample::Mode::Filling;
    value.small = 200;
    value.flags = {true, false, true};
    PropertyBag bag;
    ASSERT_TRUE(types::typeDecomposition(tank, bag, true));
    EXPECT_EQ("/sample/Tank", bag.getType());

    auto other = variable(Tank());
    ASSERT_TRUE(other->getTypeInfo()->composeType(variable(bag), other));
    EXPECT_EQ(tank->toString(), other->toString());
}

TEST_F(GeneratedTypes, DecomposedMembersReferToTheValue) {
    PropertyBag bag;
    ASSERT_TRUE(types::typeDecomposition(tank, bag, true));
    auto* y = dynamic_cast<Property<double>*>(findProperty(bag, "position.y"));
    ASSERT_NE(nullptr, y);
    y->set(6);
    EXPECT_EQ(6, value.position.y);
}

TEST_F(GeneratedTypes, CompositionKeepsWhatTheBagLacks) {
    value.id = 5;
    value.label = "old";
    PropertyBag bag;
    bag.ownProperty(new Property<std::string>("label", "", "new"));
    bag.ownProperty(new Property<int>("no_such_member", "", 1));
    EXPECT_TRUE(tank->getTypeInfo()->composeType(variable(bag), tank));
    EXPECT_EQ(5, value.id);
    EXPECT_EQ("new", value.label);
}

TEST_F(GeneratedTypes, CompositionRefusesWrongTypesAndSizes) {
    PropertyBag bag;
    bag.ownProperty(new Property<std::string>("id", "", "three"));
    EXPECT_FALSE(tank->getTypeInfo()->composeType(variable(bag), tank));
    PropertyBag small;
    small.ownProperty(new Property<int>("small", "", 300));
    EXPECT_FALSE(tank->getTypeInfo()->composeType(variable(small), tank)) << "300 does not fit into 8 bits";
    PropertyBag weights, inner;
    inner.ownProperty(new Property<double>("Element0", "", 1));
    weights.ownProperty(new Property<PropertyBag>("weights", "", inner));
    EXPECT_FALSE(tank->getTypeInfo()->composeType(variable(weights), tank)) << "an array needs all its elements";
}

TEST_F(GeneratedTypes, TypeMakesPorts) {
    const std::unique_ptr<base::OutputPortInterface> out(type("sample.Tank")->outputPort("out"));
    const std::unique_ptr<base::InputPortInterface> in(type("sample.Tank")->inputPort("in"));
    ASSERT_TRUE(out && in);
    EXPECT_TRUE(out->connectTo(in.get()));
    EXPECT_EQ(type("sample.Tank"), in->getTypeInfo());
}
