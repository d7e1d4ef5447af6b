// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/ConfigurationInterface.hpp>
#include <rtt/TaskContext.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace RTT;
using testing::ElementsAre;

namespace {

TEST(Attributes, FollowTheVariable) {
    ConfigurationInterface c;
    int variable = 1;
    EXPECT_TRUE(c.addAttribute("a", variable));
    auto* attribute = Attribute<int>::narrow(c.getAttribute("a"));
    ASSERT_TRUE(attribute);
    variable = 2;
    EXPECT_EQ(attribute->get(), 2);
    attribute->set(3);
    EXPECT_EQ(variable, 3);
}

TEST(Attributes, OfAttributeObjectsShareTheirValue) {
    ConfigurationInterface c;
    Attribute<int> own("own", 5), empty;
    EXPECT_TRUE(c.addAttribute(own));
    EXPECT_TRUE(c.addAttribute("renamed", own));
    EXPECT_FALSE(c.addAttribute(empty));
    Attribute<int>(c.getAttribute("own")).set(6);
    EXPECT_EQ(own.get(), 6);
}

TEST(Constants, ShowChangesOfTheVariableButCannotChangeIt) {
    ConfigurationInterface c;
    double variable = 1.0;
    EXPECT_TRUE(c.addConstant("c", variable));
    variable = 2.0;
    base::AttributeBase* constant = c.getConstant("c");
    ASSERT_TRUE(constant);
    EXPECT_EQ(internal::DataSource<double>::narrow(constant->getDataSource().get())->get(), 2.0);
    EXPECT_FALSE(constant->getDataSource()->isAssignable());
}

TEST(Values, OfEqualNameAreKeptAndTheFirstIsFound) {
    ConfigurationInterface c;
    int one = 1, two = 2;
    c.addAttribute("a", one);
    EXPECT_TRUE(c.addAttribute("a", two));
    EXPECT_EQ(Attribute<int>(c.getAttribute("a")).get(), 1);
    EXPECT_TRUE(c.removeAttribute("a"));
    EXPECT_EQ(Attribute<int>(c.getAttribute("a")).get(), 2);
    EXPECT_TRUE(c.removeAttribute("a"));
    EXPECT_FALSE(c.removeAttribute("a"));
}

TEST(Values, SetValueTakesOwnershipAndRefusesTheIncomplete) {
    ConfigurationInterface c;
    EXPECT_TRUE(c.setValue(new Attribute<int>("a", 1)));
    EXPECT_FALSE(c.setValue(new Attribute<int>("", 1)));
    EXPECT_FALSE(c.setValue(new Attribute<int>()));
    EXPECT_FALSE(c.setValue(nullptr));
    EXPECT_THAT(c.getAttributeNames(), ElementsAre("a"));
}

TEST(Constants, OfConstantObjectsShareTheirValue) {
    ConfigurationInterface c;
    Constant<int> own("own", 5);
    Attribute<int> attribute("attribute", 6);
    EXPECT_TRUE(c.addConstant("renamed", own));
    EXPECT_EQ(own.getName(), "renamed");
    EXPECT_TRUE(c.addConstant(own));
    EXPECT_TRUE(c.addConstant(attribute));
    EXPECT_EQ(Constant<int>(c.getConstant("renamed")).get(), 5);
    attribute.set(7);
    EXPECT_EQ(Constant<int>(c.getConstant("attribute")).get(), 7);
}

TEST(Constants, KeepAValueThatIsNoVariable) {
    ConfigurationInterface c;
    TaskContext component("component");
    const auto number = [] { return 5; };
    EXPECT_TRUE(c.addConstant("number", number()));
    EXPECT_TRUE(c.addConstant<double>("real", 3));
    EXPECT_TRUE(component.addConstant("text", std::string("a text that is longer than a short one")));
    number();
    EXPECT_EQ(Constant<int>(c.getConstant("number")).get(), 5);
    EXPECT_EQ(Constant<double>(c.getConstant("real")).get(), 3.0);
    EXPECT_EQ(Constant<std::string>(component.provides()->getConstant("text")).get(),
              "a text that is longer than a short one");
    const auto* const own =
        dynamic_cast<internal::ConstantDataSource<int>*>(c.getConstant("number")->getDataSource().get());
    EXPECT_NE(own, nullptr);
}

TEST(Values, OfEveryKindAreFoundByOneName) {
    ConfigurationInterface c;
    int variable = 1;
    const double constant = 2.0;
    c.addAttribute("a", variable);
    c.addConstant("c", constant);
    EXPECT_EQ(c.attributes(), &c);
    for (const char* name : {"a", "c"}) {
        EXPECT_TRUE(c.hasAttribute(name));
        EXPECT_EQ(c.getAttribute(name), c.getValue(name));
        EXPECT_EQ(c.getConstant(name), c.getValue(name));
        ASSERT_TRUE(c.getValue(name)->ready());
    }
    EXPECT_EQ(c.getValues().size(), 2u);
    EXPECT_EQ(c.getValue("none"), nullptr);
    EXPECT_FALSE(c.hasAttribute("none"));
    EXPECT_TRUE(c.removeValue("c"));
    EXPECT_FALSE(c.removeValue("c"));
    EXPECT_THAT(c.getAttributeNames(), ElementsAre("a"));
}

TEST(Values, AreLoadedTogether) {
    ConfigurationInterface c;
    c.loadValues({new Attribute<int>("a", 1), new Constant<int>("c", 2)});
    EXPECT_THAT(c.getAttributeNames(), ElementsAre("a", "c"));
    EXPECT_EQ(Attribute<int>(c.getAttribute("a")).get(), 1);
}

TEST(Properties, FollowTheVariable) {
    ConfigurationInterface c;
    double gain = 1.5;
    Property<double>& property = c.addProperty("gain", gain).doc("the gain");
    EXPECT_EQ(property.getDescription(), "the gain");
    property.set(2.5);
    EXPECT_EQ(gain, 2.5);
    EXPECT_EQ(c.getProperty("gain"), &property);
    EXPECT_TRUE(c.properties()->ownsProperty(&property));
}

TEST(Properties, OfTheUserAreReferredTo) {
    ConfigurationInterface c;
    Property<int> own("own", "text", 4), same("own", "other", 5), unready;
    EXPECT_TRUE(c.addProperty(own));
    EXPECT_FALSE(c.addProperty(same)) << "the name is taken";
    EXPECT_FALSE(c.addProperty(unready));
    EXPECT_EQ(c.getProperty("own"), &own);
    EXPECT_TRUE(c.removeProperty(own));
    EXPECT_FALSE(c.hasProperty("own"));
    EXPECT_EQ(own.get(), 4);
}

TEST(Properties, AreRenamedByTheNameTheyAreAddedUnder) {
    ConfigurationInterface c;
    Property<int> own("own", "text", 4);
    EXPECT_EQ(&c.addProperty("other", own), &own);
    EXPECT_EQ(own.getName(), "other");
    EXPECT_EQ(c.getProperty("other"), &own);
    EXPECT_FALSE(c.properties()->ownsProperty(&own));
}

TEST(Properties, OfVariablesMayHaveEqualNames) {
    ConfigurationInterface c;
    int one = 1, two = 2;
    Property<int>& first = c.addProperty("p", one);
    c.addProperty("p", two);
    EXPECT_EQ(c.properties()->size(), 2u);
    EXPECT_EQ(c.getProperty("p"), &first);
}

TEST(Properties, AreFoundAtTheTopLevelOnly) {
    ConfigurationInterface c;
    PropertyBag group;
    Property<int> inner("inner", "", 1);
    group.addProperty(inner);
    c.addProperty("group", group);
    EXPECT_TRUE(c.hasProperty("group"));
    EXPECT_FALSE(c.hasProperty("inner"));
    EXPECT_EQ(c.getProperty("group.inner"), nullptr);
}

TEST(Clear, RemovesAttributesAndProperties) {
    ConfigurationInterface c;
    int variable = 1;
    Property<int> own("own", "", 4);
    c.addAttribute("a", variable);
    c.addProperty("p", variable);
    c.addProperty(own);
    c.clear();
    EXPECT_TRUE(c.getValues().empty());
    EXPECT_EQ(c.properties()->size(), 0u);
    EXPECT_EQ(own.get(), 4);
}

}  // namespace
