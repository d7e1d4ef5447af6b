// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_typekit.hpp"

#include <rtt/Attribute.hpp>
#include <rtt/Property.hpp>
#include <rtt/base/PropertyIntrospection.hpp>

#include <boost/make_shared.hpp>
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

// 0 and {} are values, though they would do as a pointer to a data source.
TEST(Property, ZeroIsAValue) {
    EXPECT_EQ(Property<double>("n", "d", 0).get(), 0.0);
    EXPECT_EQ(Property<bool>("n", "d", 0).get(), false);
    EXPECT_EQ(Property<unsigned>("n", "d", 0).get(), 0u);
    EXPECT_EQ(Property<long>("n", "d", 0).get(), 0L);
    EXPECT_EQ(Property<char>("n", "d", 0).get(), '\0');
    EXPECT_EQ(Attribute<double>("n", 0).get(), 0.0);
    EXPECT_EQ(Attribute<bool>("n", 0).get(), false);
    EXPECT_EQ(Constant<double>("n", 0).get(), 0.0);
    EXPECT_EQ(Constant<unsigned long>("n", 0).get(), 0ul);
    EXPECT_TRUE(Property<double>("n", "d", {}).ready());
    EXPECT_TRUE(Property<std::string>("n", "d", {}).ready());
    EXPECT_TRUE(Attribute<double>("n", {}).ready());
    EXPECT_FALSE(Property<double>("n", "d", nullptr).ready());
    EXPECT_FALSE(Attribute<double>("n", nullptr).ready());
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

TEST(Property, UpdatesTakePropertiesByReferenceToo) {
    Property<int> target("t", "", 1), source("s", "from s", 2);
    EXPECT_TRUE(target.refresh(source));
    EXPECT_EQ(2, target.get());
    EXPECT_TRUE(target.update(source));
    EXPECT_TRUE(target.copy(source));
    EXPECT_EQ("s", target.getName());
    target <<= Property<int>("x", "", 9);
    EXPECT_EQ(9, target.get());
}

TEST(Property, StreamsItsValue) {
    Property<std::string> text("t", "", "word");
    Property<int> number("n", "", 1);
    std::ostringstream out;
    out << text << ' ' << number;
    EXPECT_EQ("word 1", out.str());
    std::istringstream in("other 5 x");
    in >> text >> number;
    EXPECT_EQ("other", text.get());
    EXPECT_EQ(5, number.get());
    in >> number;
    EXPECT_TRUE(in.fail());
    EXPECT_EQ(5, number.get());
}

TEST(Property, ComposesFromAPropertyOfBag) {
    PropertyBag bag;
    Property<PropertyBag> row("row", "");
    row.value().ownProperty(new Property<int>("x", "", 1));
    bag.ownProperty(row.clone());
    Property<PropertyBag> found = bag.getProperty("row");
    ASSERT_TRUE(found.ready());
    Property<PropertyBag> target("target");
    EXPECT_TRUE(target.compose(found));
    EXPECT_EQ(1u, target.get().size());
    Property<double> none = bag.getProperty("no such");
    EXPECT_FALSE(none.ready());
    EXPECT_FALSE(Property<int>("n").compose(found)) << "an int has no members";
}

namespace {
/** As users derive from the classes. */
class Gain : public Property<double> {
public:
    explicit Gain(const std::string& name) : Property<double>(name, "a gain", 2) {}
    double twice() const { return 2 * this->_value->get(); }
};
class Gains : public PropertyBag {
public:
    Gains() : PropertyBag("Gains") { this->addProperty(gain); }
    std::size_t count() const { return this->mproperties.size(); }
    Gain gain{"gain"};
};
}  // namespace

TEST(Property, ClassesMayBeDerived) {
    Gains gains;
    gains.gain.set(3);
    EXPECT_EQ(6, gains.gain.twice());
    EXPECT_EQ(1u, gains.count());
    EXPECT_EQ(3, gains.getPropertyType<double>("gain")->get());
    std::vector<boost::shared_ptr<Property<double>>> several{boost::make_shared<Gain>("a")};
    std::vector<Property<double>> values(2, Property<double>("b", "", 1));
    values[1] = 5;
    values.emplace_back("c", "", 6);
    EXPECT_EQ(1, values[0].get());
    EXPECT_EQ(5, values[1].get());
    EXPECT_EQ(2, several[0]->get());
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
