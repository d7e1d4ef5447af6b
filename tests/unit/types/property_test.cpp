// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_typekit.hpp"

#include <rtt/Attribute.hpp>
#include <rtt/Property.hpp>
#include <rtt/base/PropertyIntrospection.hpp>

#include <memory>
#include <sstream>

using namespace RTT;

TEST(Property, HoldsItsValue) {
    Property<double> p("gain", "of the loop", 1.5);
    EXPECT_EQ(1.5, p.get());
    p = 2.5;
    EXPECT_EQ(2.5, p.rvalue());
    p.set() = 3;
    const double converted = p;
    EXPECT_EQ(3, converted);
    EXPECT_EQ("gain", p.getName());
    EXPECT_EQ("of the loop", p.getDescription());
    EXPECT_EQ("other", p.doc("other").getDescription());
}

TEST(Property, DefaultConstructedIsNotReady) {
    Property<int> p;
    EXPECT_FALSE(p.ready());
    EXPECT_FALSE(p.update(&p));
}

TEST(Property, RefersToAVariable) {
    bool flag = false;
    Property<bool> p("flag", "", new internal::ReferenceDataSource<bool>(flag));
    EXPECT_FALSE(p.get()) << "the pointer must not be taken for the value";
    p = true;
    EXPECT_TRUE(flag);
}

TEST(Property, CopyHasItsOwnValue) {
    Property<int> a("a", "", 1), b(a);
    b = 2;
    EXPECT_EQ(1, a.get());
    a = b;
    EXPECT_EQ(2, a.get());
    const std::unique_ptr<base::PropertyBase> c(a.clone()), d(a.create());
    EXPECT_EQ(2, Property<int>(c.get()).get());
    EXPECT_EQ(0, Property<int>(d.get()).get());
}

TEST(Property, FromBaseSharesTheValueOfTheRightType) {
    Property<int> p("a", "doc", 1);
    base::PropertyBase* anonymous = &p;
    Property<int> shared = anonymous;
    shared = 5;
    EXPECT_EQ(5, p.get());
    EXPECT_EQ("doc", shared.getDescription());
    Property<double> wrong = anonymous;
    EXPECT_FALSE(wrong.ready());
    Property<int> nothing = static_cast<base::PropertyBase*>(nullptr);
    EXPECT_FALSE(nothing.ready());
}

TEST(Property, UpdateRefreshAndCopyDiffer) {
    Property<int> target("t", "", 1), source("s", "from s", 2);
    EXPECT_TRUE(target.refresh(&source));
    EXPECT_EQ("", target.getDescription());
    EXPECT_TRUE(target.update(&source));
    EXPECT_EQ("from s", target.getDescription());
    EXPECT_EQ("t", target.getName());
    EXPECT_TRUE(target.copy(&source));
    EXPECT_EQ("s", target.getName());
    Property<std::string> text("x", "", "y");
    EXPECT_FALSE(target.update(&text));
    EXPECT_EQ(2, target.get());
}

TEST(Property, CommandsUpdateWhenExecuted) {
    Property<int> target("t", "", 1), source("s", "", 2);
    Property<std::string> text("x", "", "y");
    const std::unique_ptr<base::ActionInterface> action(target.refreshCommand(&source));
    ASSERT_TRUE(action);
    action->readArguments();
    EXPECT_TRUE(action->execute());
    EXPECT_EQ(2, target.get());
    EXPECT_EQ(nullptr, target.refreshCommand(&text));
}

namespace {
struct Visitor : base::PropertyIntrospection {
    using base::PropertyIntrospection::introspect;
    std::string seen;
    void introspect(base::PropertyBase*) override { seen += "other "; }
    void introspect(Property<bool>&) override { seen += "bool "; }
    void introspect(Property<char>&) override { seen += "char "; }
    void introspect(Property<int>&) override { seen += "int "; }
    void introspect(Property<unsigned int>&) override { seen += "uint "; }
    void introspect(Property<double>&) override { seen += "double "; }
    void introspect(Property<float>&) override { seen += "float "; }
    void introspect(Property<std::string>&) override { seen += "string "; }
    void introspect(Property<PropertyBag>&) override { seen += "bag "; }
};
}  // namespace

TEST(Property, VisitorSeesTheType) {
    PropertyBag bag;
    bag.ownProperty(new Property<bool>("a"));
    bag.ownProperty(new Property<std::string>("b"));
    bag.ownProperty(new Property<std::vector<double>>("c"));
    bag.ownProperty(new Property<PropertyBag>("d"));
    bag.ownProperty(new Property<long long>("e"));
    Visitor visitor;
    bag.identify(&visitor);
    EXPECT_EQ("bool string other bag other ", visitor.seen);
}

TEST(Attribute, IsAVariable) {
    Attribute<int> a("count", 3);
    a.set(4);
    EXPECT_EQ(4, a.get());
    EXPECT_TRUE(a.ready());
    EXPECT_FALSE(Attribute<int>().ready());
    base::AttributeBase* anonymous = &a;
    Attribute<int> shared = anonymous;
    shared.set(5);
    EXPECT_EQ(5, a.get());
    EXPECT_FALSE(Attribute<double>(anonymous).ready());
}

TEST(Attribute, ConstantAndAlias) {
    Constant<double> pi("pi", 3.14);
    EXPECT_EQ(3.14, pi.get());
    EXPECT_FALSE(pi.getDataSource()->isAssignable());
    Alias alias("same", pi.getDataSource());
    EXPECT_EQ(pi.getDataSource(), alias.getDataSource());
}

TEST(Attribute, InstantiatedCopyIsIndependent) {
    Attribute<int> a("count", 3);
    internal::CopyMap copies;
    const std::unique_ptr<Attribute<int>> same(a.copy(copies, false));
    same->set(4);
    EXPECT_EQ(4, a.get());
    const std::unique_ptr<Attribute<int>> own(a.copy(copies, true));
    own->set(9);
    EXPECT_EQ(4, a.get());
}
