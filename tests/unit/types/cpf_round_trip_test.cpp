// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values of all types go through a property file unchanged, and writing them again gives the same file.
#include "cpf_fixture.hpp"

#include <rtt/rt_string.hpp>
#include <cpf/cpf_writer.hpp>
#include <cpf/property_file.hpp>

#include <gmock/gmock.h>

#include <cstring>

using namespace RTT;
using namespace RTT::marsh;
using namespace types_test;

namespace {

class CpfRoundTrip : public Cpf {
protected:
    /** Stores the bag, loads the file into `target`, stores that: both files are the same. */
    void expectFixedPoint(PropertyBag& target) {
        ASSERT_TRUE(saveToFile(bag, file, SaveMode::store, sink)) << said();
        const std::string first = get();
        ASSERT_TRUE(loadFromFile(target, file, LoadMode::load, sink)) << said() << first;
        ASSERT_TRUE(saveToFile(target, file, SaveMode::store, sink)) << said();
        EXPECT_EQ(first, get());
        ASSERT_TRUE(saveToFile(bag, file, SaveMode::merge, sink)) << said();
        EXPECT_EQ(first, get()) << "there is nothing to change in it";
    }
    template <class T>
    void own(const std::string& name, const T& value, PropertyBag& target) {
        bag.ownProperty(new Property<T>(name, "of " + name, value));
        target.ownProperty(new Property<T>(name, "of " + name));
    }
};

/** Types whose values have no form in property files. */
bool isLeftOut(const std::string& type) {
    return type == "void" || type == "unknown_t" || type == "TaskContext" || type == "PropertyBag";
}

}  // namespace

TEST_F(CpfRoundTrip, EveryTypeWithItsDefaultValue) {
    PropertyBag target;
    int count = 0;
    for (const auto& name : types::Types()->getTypes()) {
        const types::TypeInfo* info = type(name);
        if (isLeftOut(name) || !info->buildValue()) continue;
        bag.ownProperty(info->buildProperty(name, "of a test", info->buildValue()));
        target.ownProperty(info->buildProperty(name, "of a test", info->buildValue()));
        ++count;
    }
    EXPECT_GT(count, 25);
    expectFixedPoint(target);
}

TEST_F(CpfRoundTrip, RealTimeTextIsWrittenAsText) {
    PropertyBag target;
    own<rt_string>("name", " two  words & more\n", target);
    expectFixedPoint(target);
    EXPECT_THAT(get(), testing::HasSubstr("<simple name=\"name\" type=\"string\">"));
    EXPECT_EQ(" two  words & more\n", target.getPropertyType<rt_string>("name")->get());
}

TEST_F(CpfRoundTrip, BuiltInTypesWithValues) {
    PropertyBag target;
    own<signed char>("int8", -128, target);
    own<unsigned char>("uint8", 255, target);
    own<short>("int16", -32768, target);
    own<unsigned short>("uint16", 65535, target);
    own<long>("int64", std::numeric_limits<long>::min(), target);
    own<unsigned long>("uint64", std::numeric_limits<unsigned long>::max(), target);
    own<std::vector<double>>("array", {0.1, -0.0, 1e300}, target);
    own<std::vector<double>>("empty", {}, target);
    own<ConnPolicy>("policy", ConnPolicy::buffer(7), target);
    own<FlowStatus>("status", NewData, target);
    own<std::string>("text", " a\n b ", target);
    expectFixedPoint(target);
    for (std::size_t i = 0; i != bag.size(); ++i)
        EXPECT_EQ(bag.getItem(i)->getDataSource()->toString(), target.getItem(i)->getDataSource()->toString());
}

TEST_F(CpfRoundTrip, GeneratedTypesAtAnyDepth) {
    sample::Tank tank;
    tank.label = "  <north> & \"south\"\n";
    tank.levels = {0.1, 1e300, -0.0};
    tank.path = {{1, 2}, {3, 4}};
    tank.weights[1] = 5e-324;
    tank.pair = {-1, 2};
    tank.mode = sample::Mode::Draining;
    tank.small = 255;
    tank.flags = {true, false};
    PropertyBag target, nested("PropertyBag"), deep;
    own("tank", tank, target);
    own("path", tank.path, target);
    own("none", std::vector<sample::Point>(), target);
    deep.ownProperty(new Property<sample::Point>("at", "", sample::Point{1, 2}));
    nested.ownProperty(new Property<PropertyBag>("deep", "", deep));
    nested.ownProperty(new Property<PropertyBag>("hollow", "nothing in it", PropertyBag()));
    bag.ownProperty(new Property<PropertyBag>("nested", "", nested));
    expectFixedPoint(target);
    EXPECT_EQ(variable(tank)->toString(), target.find("tank")->getDataSource()->toString());
    auto* at = dynamic_cast<Property<sample::Point>*>(findProperty(target, "nested.deep.at"));
    ASSERT_NE(nullptr, at) << "created as a value of the type that the file names";
    EXPECT_EQ(2, at->get().y);
    EXPECT_NE(nullptr, findProperty(target, "nested.hollow"));
}

TEST_F(CpfRoundTrip, EqualNamesAndUnnamedItemsKeepTheirOrder) {
    PropertyBag target;
    for (int i : {1, 2, 3}) bag.ownProperty(new Property<int>("same", "", i));
    for (int i : {4, 5}) bag.ownProperty(new Property<int>("", "", i));
    expectFixedPoint(target);
    ASSERT_EQ(5u, target.size());
    for (int i = 0; i != 5; ++i) EXPECT_EQ(i + 1, Property<int>(target.getItem(i)).get());
}

TEST_F(CpfRoundTrip, SequencesOfStructsAreReadFromSequenceElements) {
    put("<sequence name=\"path\" type=\"anything\">"
        "<struct type=\"sample.Point\"><simple name=\"x\" type=\"double\"><value>1</value></simple></struct>"
        "<struct type=\"sample.Point\"><simple name=\"y\" type=\"long\"><value>2</value></simple></struct>"
        "</sequence><struct name=\"levels\" type=\"array\"><simple type=\"double\"><value>1</value></simple>"
        "<simple type=\"float\"><value>2</value></simple></struct>");
    bag.ownProperty(new Property<std::vector<sample::Point>>("path", ""));
    bag.ownProperty(new Property<std::vector<double>>("levels", "", {9, 9, 9}));
    ASSERT_TRUE(loadFromFile(bag, file, LoadMode::refresh, sink)) << said();
    EXPECT_EQ("{{x = 1, y = 0}, {x = 0, y = 2}}", bag.find("path")->getDataSource()->toString());
    EXPECT_EQ((std::vector<double>{1, 2}), bag.getPropertyType<std::vector<double>>("levels")->get());
}

TEST_F(CpfRoundTrip, ThousandsOfProperties) {
    PropertyBag target;
    for (int i = 0; i != 20000; ++i) own("p" + std::to_string(i), i, target);
    expectFixedPoint(target);
    EXPECT_EQ(19999, target.getPropertyType<int>("p19999")->get());
    PropertyBag copy(target);
    EXPECT_TRUE(updateProperties(copy, bag));
    EXPECT_EQ(20000u, copy.size());
}
