// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_typekit.hpp"

#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/types/PropertyComposition.hpp>
#include <rtt/types/PropertyDecomposition.hpp>

#include <memory>
#include <sstream>

using namespace RTT;
using namespace types_test;

namespace {

class Bag : public WithBuiltinTypes {
protected:
    void SetUp() override {
        bag.ownProperty(new Property<int>("a", "first", 1));
        bag.ownProperty(new Property<PropertyBag>("b", "inner"));
        inner().ownProperty(new Property<double>("c", "deep", 2.5));
    }
    PropertyBag& inner() { return bag.getPropertyType<PropertyBag>("b")->value(); }
    PropertyBag bag;
};

typedef std::vector<std::string> Names;

}  // namespace

TEST_F(Bag, FindsByNameTypeAndValue) {
    EXPECT_EQ("a", bag.find("a")->getName());
    EXPECT_EQ(nullptr, bag.find("c"));
    ASSERT_NE(nullptr, bag.getPropertyType<int>("a"));
    EXPECT_EQ(nullptr, bag.getPropertyType<double>("a"));
    EXPECT_EQ(bag.find("a"), bag.findValue<int>(1));
    EXPECT_EQ(nullptr, bag.findValue<int>(2));
    EXPECT_EQ((Names{"a", "b"}), bag.list());
    EXPECT_EQ(nullptr, bag.getItem(2));
}

TEST_F(Bag, OwnsOrRefers) {
    Property<int> outside("x", "", 1), notReady;
    EXPECT_TRUE(bag.addProperty(outside));
    EXPECT_FALSE(bag.ownsProperty(&outside));
    EXPECT_FALSE(bag.addProperty(notReady));
    EXPECT_TRUE(bag.removeProperty(&outside));
    EXPECT_FALSE(bag.removeProperty(&outside));
    int number = 3;
    bag.addProperty("n", number) = 4;
    EXPECT_EQ(4, number);
    EXPECT_TRUE(bag.ownsProperty(bag.find("n")));
}

TEST_F(Bag, CopyIsDeepForWhatItOwns) {
    PropertyBag copy(bag);
    copy.getPropertyType<int>("a")->set(9);
    findProperty(copy, "b.c")->refresh(std::make_unique<Property<double>>("c", "", 7.0).get());
    EXPECT_EQ(1, bag.getPropertyType<int>("a")->get());
    EXPECT_EQ(2.5, inner().getPropertyType<double>("c")->get());
}

TEST_F(Bag, Paths) {
    EXPECT_EQ((Names{"a", "b", "b.c"}), listProperties(bag));
    EXPECT_EQ((Names{"first", "inner", "deep"}), listPropertyDescriptions(bag));
    EXPECT_EQ("c", findProperty(bag, "b.c")->getName());
    EXPECT_EQ(nullptr, findProperty(bag, "b.x"));
    EXPECT_EQ(findProperty(bag, "b"), findProperty(bag, ".b"));
    EXPECT_EQ(findProperty(bag, "b.c"), findProperty(bag, "..b..c"));
    EXPECT_EQ(findProperty(bag, "b.c"), findProperty(bag, "//b//c", "/"));
    EXPECT_EQ(nullptr, findProperty(bag, "."));
    EXPECT_EQ(nullptr, findProperty(bag, ""));
    EXPECT_TRUE(storeProperty(bag, "d.e", new Property<int>("f", "", 1)));
    EXPECT_NE(nullptr, findProperty(bag, "d.e.f"));
    EXPECT_TRUE(removeProperty(bag, "d.e.f"));
    EXPECT_EQ(nullptr, findProperty(bag, "d.e.f"));
    EXPECT_FALSE(removeProperty(bag, "d.e.f"));
}

TEST_F(Bag, SeveralSeparatorsAreOneInAllPaths) {
    EXPECT_TRUE(storeProperty(bag, "..d..e", new Property<int>("f", "", 1)));
    EXPECT_EQ((Names{"a", "b", "b.c", "d", "d.e", "d.e.f"}), listProperties(bag));
    PropertyBag source(bag), target;
    EXPECT_TRUE(refreshProperty(bag, source, ".b..c"));
    EXPECT_TRUE(updateProperty(target, source, ".d...e..f"));
    EXPECT_EQ((Names{"d", "d.e", "d.e.f"}), listProperties(target));
    EXPECT_TRUE(removeProperty(bag, "..d..e...f"));
    EXPECT_EQ(nullptr, findProperty(bag, "d.e.f"));
    EXPECT_TRUE(removeProperty(bag, ".a"));
    EXPECT_TRUE(removeProperty(bag, "::b::::c", "::"));
    EXPECT_EQ((Names{"b", "d", "d.e"}), listProperties(bag));
    bag.ownProperty(new Property<int>(".hidden", "", 1));
    EXPECT_NE(nullptr, findProperty(bag, ".hidden")) << "a name may begin so";
}

TEST_F(Bag, NothingIsTakenApartOrPutTogetherIntoABagThatHasTheName) {
    for (auto* const step : {&types::decomposePropertyBag, &types::composePropertyBag}) {
        PropertyBag target;
        target.ownProperty(new Property<double>("b", "", 0.5));
        EXPECT_FALSE(step(bag, target));
        EXPECT_EQ((Names{"b"}), target.list());
        PropertyBag other;
        other.ownProperty(new Property<double>("c", "", 0.5));
        EXPECT_TRUE(step(bag, other)) << "the names differ";
        EXPECT_EQ((Names{"c", "a", "b"}), other.list());
    }
    bag.ownProperty(new Property<int>("a", "again", 3));
    PropertyBag twice;
    EXPECT_TRUE(types::decomposePropertyBag(bag, twice)) << "those of one bag may share a name";
    EXPECT_EQ((Names{"a", "b", "a"}), twice.list());
}

TEST_F(Bag, RefreshTouchesWhatBothHave) {
    PropertyBag source;
    source.ownProperty(new Property<int>("a", "other", 5));
    source.ownProperty(new Property<int>("new", "", 6));
    EXPECT_TRUE(refreshProperties(bag, source));
    EXPECT_EQ(5, bag.getPropertyType<int>("a")->get());
    EXPECT_EQ("first", bag.find("a")->getDescription());
    EXPECT_EQ(nullptr, bag.find("new"));
    EXPECT_FALSE(refreshProperties(bag, source, true)) << "b is missing in the source";
}

TEST_F(Bag, UpdateAddsWhatIsMissing) {
    PropertyBag source, deep;
    deep.ownProperty(new Property<int>("d", "", 6));
    source.ownProperty(new Property<PropertyBag>("b", "", deep));
    source.ownProperty(new Property<int>("new", "", 7));
    EXPECT_TRUE(updateProperties(bag, source));
    EXPECT_EQ((Names{"a", "b", "b.c", "b.d", "new"}), listProperties(bag));
}

TEST_F(Bag, ValuesAreConverted) {
    PropertyBag source;
    source.ownProperty(new Property<int>("c", "", 4));
    EXPECT_TRUE(refreshProperties(inner(), source));
    EXPECT_EQ(4.0, inner().getPropertyType<double>("c")->get());
}

TEST_F(Bag, AllMismatchesAreReportedAndTheRestIsDone) {
    PropertyBag source;
    source.ownProperty(new Property<std::string>("a", "", "text"));
    source.ownProperty(new Property<int>("z", "", 4));
    bag.ownProperty(new Property<int>("z", "", 0));
    EXPECT_FALSE(refreshProperties(bag, source));
    EXPECT_EQ(4, bag.getPropertyType<int>("z")->get());
    EXPECT_EQ(1, bag.getPropertyType<int>("a")->get());
}

TEST_F(Bag, EqualNamesArePairedInOrder) {
    PropertyBag target, source;
    for (int i : {1, 2}) target.ownProperty(new Property<int>("same", "", i));
    for (int i : {10, 20, 30}) source.ownProperty(new Property<int>("same", "", i));
    EXPECT_TRUE(updateProperties(target, source));
    ASSERT_EQ(3u, target.size());
    for (int i = 0; i != 3; ++i) EXPECT_EQ(10 * (i + 1), Property<int>(target.getItem(i)).get());
}

TEST_F(Bag, EachOfManyEqualNamesIsAdded) {
    PropertyBag target, source;
    target.ownProperty(new Property<int>("same", "", 1));
    for (int i : {10, 20, 30, 40}) source.ownProperty(new Property<int>("same", "", i));
    EXPECT_TRUE(updateProperties(target, source));
    ASSERT_EQ(4u, target.size());
    for (int i = 0; i != 4; ++i) EXPECT_EQ(10 * (i + 1), Property<int>(target.getItem(i)).get());
}

TEST_F(Bag, OwningTwiceOrAfterReferringKeepsOneEntry) {
    auto* property = new Property<int>("x", "", 1);
    EXPECT_TRUE(bag.add(property));
    EXPECT_FALSE(bag.ownsProperty(property));
    EXPECT_TRUE(bag.ownProperty(property));
    EXPECT_TRUE(bag.ownProperty(property));
    EXPECT_TRUE(bag.ownsProperty(property));
    EXPECT_EQ((Names{"a", "b", "x"}), bag.list());
    EXPECT_TRUE(bag.remove(property));
    EXPECT_FALSE(bag.ownProperty(nullptr));
    EXPECT_EQ(2u, bag.size());
}

TEST_F(Bag, AnOwnedPropertyThatIsThereTwiceLeavesNothingBehind) {
    auto* property = bag.find("a");
    EXPECT_TRUE(bag.add(property));
    EXPECT_EQ((Names{"a", "b", "a"}), bag.list());
    EXPECT_TRUE(bag.removeProperty(property));
    EXPECT_EQ((Names{"b"}), bag.list());
}

TEST_F(Bag, OperatorReplacesByName) {
    PropertyBag source;
    source.ownProperty(new Property<double>("a", "", 0.5));
    source.ownProperty(new Property<int>("new", "", 1));
    bag <<= source;
    EXPECT_EQ((Names{"b", "a", "new"}), bag.list());
    EXPECT_NE(nullptr, bag.getPropertyType<double>("a"));
    EXPECT_FALSE(bag.ownsProperty(bag.find("a")));
}

TEST_F(Bag, ValuesThatCannotBeConvertedAreLeftAlone) {
    PropertyBag source;
    storeProperty(source, "b", new Property<std::string>("c", "", "text"));
    EXPECT_FALSE(refreshProperties(bag, source));
    EXPECT_EQ(2.5, inner().getPropertyType<double>("c")->get());
}

TEST_F(Bag, UnnamedItemsAreMatchedByIndex) {
    PropertyBag target, source;
    for (int i : {1, 2}) target.ownProperty(new Property<int>("", "", i));
    for (int i : {10, 20}) source.ownProperty(new Property<int>("", "", i));
    EXPECT_TRUE(refreshProperties(target, source));
    EXPECT_EQ(20, Property<int>(target.getItem(1)).get());
}

TEST_F(Bag, TypedBagRefusesAnotherType) {
    inner().setType("Mine");
    PropertyBag source, other("Other");
    source.ownProperty(new Property<PropertyBag>("b", "", other));
    EXPECT_FALSE(refreshProperties(bag, source));
}

TEST_F(Bag, SinglePropertiesByPath) {
    PropertyBag source;
    storeProperty(source, "b", new Property<double>("c", "", 8.0));
    storeProperty(source, "q", new Property<int>("r", "", 1));
    EXPECT_TRUE(refreshProperty(bag, source, "b.c"));
    EXPECT_EQ(8.0, inner().getPropertyType<double>("c")->get());
    EXPECT_FALSE(refreshProperty(bag, source, "q.r"));
    EXPECT_TRUE(updateProperty(bag, source, "q.r"));
    EXPECT_NE(nullptr, findProperty(bag, "q.r"));
    EXPECT_FALSE(updateProperty(bag, source, "q.x"));
}

TEST_F(Bag, FlattenKeepsValuesLiveAndEmptyBags) {
    auto c = inner().find("c")->getDataSource();
    bag.ownProperty(new Property<PropertyBag>("empty"));
    flattenPropertyBag(bag);
    EXPECT_EQ((Names{"a", "b.c", "empty"}), bag.list());
    c->update(variable(9.0).get());
    EXPECT_EQ(9.0, bag.getPropertyType<double>("b.c")->get());
}

TEST_F(Bag, StreamForm) {
    PropertyBag small;
    small.ownProperty(new Property<int>("a", "", 1));
    std::ostringstream text;
    text << small;
    EXPECT_EQ("[[a='1'\n]]", text.str());
}

TEST_F(Bag, DeleteEmptiesEverything) {
    PropertyBag all;
    all.add(new Property<int>("x", "", 1));
    auto* deep = new Property<PropertyBag>("y");
    deep->value().add(new Property<int>("z", "", 1));
    all.add(deep);
    deletePropertyBag(all);
    EXPECT_TRUE(all.empty());
}
