// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Both ways with types of all shapes, and with those that only their typekit takes apart.
#include "param_fixture.hpp"

#include "../encoding/encoded_types.hpp"

#include <rtt_rosparam/parameter_binding.hpp>

#include <cstddef>
#include <thread>

namespace param_test {

namespace t = RTT::types;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/** Of a typekit without tables. */
struct Gear {
    int teeth = 0;
    double ratio = 0;
};
class GearInfo : public t::TemplateTypeInfo<Gear> {
public:
    GearInfo() : t::TemplateTypeInfo<Gear>("/demo/Gear") {}
    bool decomposeTypeImpl(const Gear& source, RTT::PropertyBag& target) const override {
        target.setType("/demo/Gear");
        target.ownProperty(new RTT::Property<int>("teeth", "", source.teeth));
        return target.ownProperty(new RTT::Property<double>("ratio", "", source.ratio));
    }
    bool composeTypeImpl(const RTT::PropertyBag& source, Gear& result) const override {
        const auto* const teeth = source.getPropertyType<int>("teeth");
        const auto* const ratio = source.getPropertyType<double>("ratio");
        if (!teeth || !ratio) return false;
        result = {teeth->get(), ratio->get()};
        return true;
    }
};

struct Boxed {
    RTT::PropertyBag bag;
};
constexpr t::Member boxedMembers[] = {{"bag", offsetof(Boxed, bag), &t::typeRef<RTT::PropertyBag>, 0, "", ""}};

class TypesOfParameters : public WithMaster {
protected:
    static void SetUpTestSuite() {
        WithMaster::SetUpTestSuite();
        const auto types = t::Types();
        types->addType(new GearInfo());
        types->addType(new encoded::ForeignInfo());
        types->addType(t::makeStructType<encoded::Tree>("/encoded/Tree", encoded::treeMembers, 2));
        types->addType(t::makeSequenceType<std::vector<encoded::Tree>>("/std/vector</encoded/Tree>"));
        types->addType(t::makeSequenceType<std::vector<int>>("/std/vector</int>"));
        types->addType(t::makeAdaptedMatrix<encoded::MatrixAccess>("/encoded/Matrix", ""));
        types->addType(t::makeStructType<encoded::Picky>("/encoded/Picky", encoded::pickyMembers, 1));
        types->addType(t::makeStructType<Boxed>("/demo/Boxed", boxedMembers, 1));
        types->addType(t::makeStructType<encoded::Nothing>("/encoded/Nothing", nullptr, 0));
        types->addType(t::detail::newSequenceGenerator("/std/list</int>", t::linkedOps<std::list<int>>(),
                                                       t::typeOps<std::list<int>>(), t::typeThunks<std::list<int>>()));
        types->addType(t::makeVariantType<encoded::Choice>("/encoded/Choice", encoded::choiceNames));
    }
};

TEST_F(TypesOfParameters, OnlyTakenApart) {
    const Value gear = made(Gear{12, 0.5});
    EXPECT_EQ(Value(12), gear[std::string("teeth")]);
    Value given;
    given["teeth"] = 20;
    EXPECT_EQ(20, got(given, Gear{1, 2}).teeth);
    EXPECT_EQ(2, got(given, Gear{1, 2}).ratio) << "it is not in the parameter";
    given["ratio"] = "x";
    EXPECT_EQ(1, got(given, Gear{1, 2}, false).teeth);
    EXPECT_THAT(log_.take(), HasSubstr("'/n/c/p/ratio' is a string ('x')"));
    EXPECT_EQ(1, got(3, Gear{1, 2}, false).teeth);
}

TEST_F(TypesOfParameters, FoundByTheirMembers) {
    EXPECT_EQ(Value(0.5), made(encoded::Foreign{1, 0.5})[std::string("b")]);
    Value given;
    given["b"] = 3;
    const auto foreign = got(given, encoded::Foreign{1, 2});
    EXPECT_EQ(3, foreign.b);
    EXPECT_EQ(1, foreign.a);
}

TEST_F(TypesOfParameters, Trees) {
    encoded::Tree tree{1, {{2, {}}, {3, {{4, {}}}}}};
    const Value parameter = made(tree);
    EXPECT_EQ(4, got(parameter, encoded::Tree()).branches.at(1).branches.at(0).value);
    for (int i = 0; i != 70; ++i) tree = encoded::Tree{i, {tree}};
    (void)made(tree, false);
    EXPECT_THAT(log_.take(), HasSubstr("nests too deeply"));
}

TEST_F(TypesOfParameters, Containers) {
    EXPECT_EQ(array(1, 2), made(std::list<int>{1, 2}));
    EXPECT_THAT(got(array(1, 2), std::list<int>{7}), ElementsAre(1, 2));
    EXPECT_THAT(got(array(1, "a"), std::list<int>{7}, false), ElementsAre(7));
    const encoded::Matrix matrix{2, 3, {1, 2, 3, 4, 5, 6}};
    const Value rows = made(matrix);
    EXPECT_EQ(array(array(1, 2, 3), array(4, 5, 6)), rows);
    const auto read = got(rows, encoded::Matrix());
    EXPECT_EQ(3u, read.columns);
    EXPECT_EQ(matrix.numbers, read.numbers);
    EXPECT_TRUE(got(array(array(1, 2), array(3)), encoded::Matrix(), false).numbers.empty());
    const Value nothing = made(encoded::Nothing());
    EXPECT_EQ(Value::TypeStruct, nothing.getType());
    (void)got(nothing, encoded::Nothing());
}

TEST_F(TypesOfParameters, Alternatives) {
    const Value parameter = made(encoded::Choice(5));
    EXPECT_EQ(Value("int"), parameter[std::string("alternative")]);
    EXPECT_EQ(5, std::get<int>(got(parameter, encoded::Choice(1))));
    (void)got(Value("x"), encoded::Choice(1), false);
    EXPECT_THAT(log_.take(), HasSubstr("'alternative'"));
}

TEST_F(TypesOfParameters, SettersThatThrow) {
    Value given;
    given["level"] = 3;
    EXPECT_EQ(3, got(given, encoded::Picky()).level());
    given["level"] = -1;
    EXPECT_EQ(0, got(given, encoded::Picky(), false).level());
    EXPECT_THAT(log_.take(), HasSubstr("'/n/c/p/level' is an int (-1), which cannot be a value of type int: below 0"));
}

TEST_F(TypesOfParameters, ABagThatIsAPart) {
    Boxed boxed;
    boxed.bag.ownProperty(new RTT::Property<int>("a", "", 1));
    boxed.bag.ownProperty(new RTT::Property<int>("b", "", 2));
    Value given;
    given["bag"]["a"] = 7;
    const Boxed read = got(given, boxed);
    ASSERT_TRUE(read.bag.getPropertyType<int>("a") && read.bag.getPropertyType<int>("b")) << log_.take();
    EXPECT_EQ(7, read.bag.getPropertyType<int>("a")->get());
    EXPECT_EQ(2, read.bag.getPropertyType<int>("b")->get());
    Boxed other(boxed);
    rtt_rosparam::ParameterBinding binding("/n/c/p", typeid(Boxed));
    EXPECT_TRUE(binding.read(&other)) << log_.take();
    EXPECT_EQ(7, other.bag.getPropertyType<int>("a")->get());
    EXPECT_FALSE(binding.read(&other)) << "it is known";
}

TEST_F(TypesOfParameters, TwoComponentsAtOnce) {
    const auto work = [](const std::string& name) {
        RTT::TaskContext component(name);
        int value = 0;
        component.addProperty("p", value);
        ASSERT_TRUE(component.loadService("rosparam"));
        for (int i = 0; i != 50; ++i) {
            value = i;
            ASSERT_TRUE(call(component, "setAll"));
            value = -1;
            ASSERT_TRUE(call(component, "getAll"));
            ASSERT_EQ(i, value);
        }
    };
    std::thread other([&] { work("other"); });
    work("one");
    other.join();
}

}  // namespace param_test
