// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What adapters promise beyond the values that typekit_values_test.cpp sends through every type.
#include <algorithm>
#include <cstdint>
#include <memory>

#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <rtt/types/MemberFactory.hpp>

#include "golden_typekit.hpp"

using namespace oroforge;
using RTT::types::TypeInfo;
using SourcePtr = RTT::base::DataSourceBase::shared_ptr;

namespace {

/// Scripts with one variable "v" of the type.
class AdaptedTypes : public test::GoldenTypekit {
protected:
    bool start(const std::string& typeName) {
        component.attributes()->removeAttribute("v");
        value = typeOf(typeName).buildValue();
        variable.reset(typeOf(typeName).buildAttribute("v", value));
        return component.addAttribute(*variable);
    }
    bool run(const std::string& statement) { return scripts.eval(statement); }
    std::string text() const { return value->toString(); }
    void TearDown() override { component.provides()->clear(); }

    RTT::TaskContext component{"component"};
    RTT::scripting::ScriptingService scripts{&component};
    SourcePtr value;
    std::unique_ptr<RTT::base::AttributeBase> variable;
};

class AdaptedEigen : public AdaptedTypes {};
class AdaptedKdl : public AdaptedTypes {};
class AdaptedLibrary : public AdaptedTypes {};

RTT::PropertyBag* addRow(RTT::PropertyBag& to, const std::string& name, const std::vector<double>& numbers) {
    auto* row = new RTT::Property<RTT::PropertyBag>(name, "");
    for (const double number : numbers)
        row->value().ownProperty(new RTT::Property<double>("n" + std::to_string(row->value().size()), "", number));
    to.ownProperty(row);
    return &row->value();
}

bool compose(const RTT::PropertyBag& bag, const SourcePtr& to) {
    const SourcePtr source(new RTT::internal::ConstReferenceDataSource<RTT::PropertyBag>(bag));
    return to->getTypeInfo()->composeType(source, to);
}

std::vector<std::string> only(const std::string& name) {
    const auto all = test::builtTypekits();
    return std::find(all.begin(), all.end(), name) == all.end() ? std::vector<std::string>()
                                                                : std::vector<std::string>{name};
}

}  // namespace

TEST_P(AdaptedLibrary, AResizedSequenceKeepsItsElements) {
    ASSERT_TRUE(start("ring_of_double"));
    const TypeInfo& type = *value->getTypeInfo();
    ASSERT_TRUE(type.resize(value, 2));
    EXPECT_TRUE(run("v[0] = 1.5; v[1] = 2.5"));
    ASSERT_TRUE(type.resize(value, 3));
    EXPECT_EQ(text(), "{1.5, 2.5, 0}");
    ASSERT_TRUE(type.resize(value, 1));
    EXPECT_EQ(text(), "{1.5}");
}

TEST_P(AdaptedLibrary, AFixedSizeCannotBeChanged) {
    ASSERT_TRUE(start("/library/Mask"));
    EXPECT_FALSE(value->getTypeInfo()->resize(value, 5));
    EXPECT_TRUE(run("v[3] = true"));
    EXPECT_EQ(text(), "{false, false, false, true}");
}

TEST_P(AdaptedLibrary, TheOtherNameOfAMemberIsTakenToo) {
    ASSERT_TRUE(start("/library/Position"));
    EXPECT_TRUE(run("v.X = 3.0"));
    RTT::PropertyBag bag;
    bag.ownProperty(new RTT::Property<double>("y", "", 4));
    EXPECT_TRUE(compose(bag, value));
    EXPECT_NE(text().find("x = 3, y = 4"), std::string::npos) << text();
    RTT::PropertyBag old;
    old.ownProperty(new RTT::Property<double>("X", "", 5));
    EXPECT_TRUE(compose(old, value));
    EXPECT_NE(text().find("x = 5, y = 4"), std::string::npos) << text();
    EXPECT_EQ(value->getTypeInfo()->getMemberNames().size(), 5U);
}

TEST_P(AdaptedLibrary, OneFixedSideOfAMatrixStays) {
    ASSERT_TRUE(start("/library/Grid2x"));
    EXPECT_FALSE(value->getTypeInfo()->resize(value, 3));
    RTT::PropertyBag bag;
    addRow(bag, "a", {1, 2, 3});
    addRow(bag, "b", {4, 5, 6});
    EXPECT_TRUE(compose(bag, value));
    EXPECT_EQ(text(), "{{1, 2, 3}, {4, 5, 6}}");
}

TEST_P(AdaptedLibrary, DescriptionsOfMembersAreThoseOfTheAdapter) {
    EXPECT_EQ(typeOf("/library/Angle").getMemberFactory()->describeMember("degrees"), "clockwise [deg] (0..360)");
    EXPECT_EQ(typeOf("/library/Angle").getDescription(), "an angle");
}

TEST_P(AdaptedEigen, AreCalledAndMadeAsScriptsExpect) {
    ASSERT_TRUE(start("eigen_vector"));
    EXPECT_TRUE(run("v = eigen_vector(3)"));
    EXPECT_EQ(text(), "{0, 0, 0}");
    EXPECT_TRUE(run("v = eigen_vector(2, 1.5)"));
    EXPECT_EQ(text(), "{1.5, 1.5}");
    EXPECT_TRUE(run("v[1] = v[0] + v.size"));
    EXPECT_EQ(text(), "{1.5, 3.5}");
    EXPECT_EQ(&typeOf("Eigen.VectorXd"), value->getTypeInfo());
}

TEST_P(AdaptedEigen, AMatrixTakesTheShapeOfAFile) {
    ASSERT_TRUE(start("eigen_matrix"));
    RTT::PropertyBag bag;
    addRow(bag, "a", {1, 2, 3});
    addRow(bag, "b", {4, 5, 6});
    EXPECT_TRUE(compose(bag, value));
    EXPECT_EQ(text(), "{{1, 2, 3}, {4, 5, 6}}");
    EXPECT_TRUE(run("v[1][0] = v.rows; v[1][1] = 0.5 + v.columns"));
    EXPECT_EQ(text(), "{{1, 2, 3}, {2, 3.5, 6}}");
    addRow(bag, "c", {7});
    EXPECT_FALSE(compose(bag, value));
    EXPECT_EQ(text(), "{{1, 2, 3}, {2, 3.5, 6}}");
}

TEST_P(AdaptedEigen, FixedOnesBeginWithZerosOrWithoutATurn) {
    const std::pair<const char*, const char*> all[] = {
        {"Eigen.Vector4d", "{0, 0, 0, 0}"},
        {"Eigen.Matrix3d", "{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}"},
        {"Eigen.Quaterniond", "{x = 0, y = 0, z = 0, w = 1}"},
        {"Eigen.Isometry3d", "{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}"}};
    for (const auto& [name, first] : all) EXPECT_EQ(typeOf(name).buildValue()->toString(), first) << name;
}

TEST_P(AdaptedEigen, ScriptsMakeValuesOfNumbers) {
    ASSERT_TRUE(start("Eigen.Quaterniond"));
    EXPECT_TRUE(run("v = Eigen.Quaterniond(1, 2, 3, 4.5)"));
    EXPECT_EQ(text(), "{x = 2, y = 3, z = 4.5, w = 1}");
    ASSERT_TRUE(start("Eigen.Vector4d"));
    EXPECT_TRUE(run("v = Eigen.Vector4d(1, 2, 3, 4)"));
    EXPECT_EQ(text(), "{1, 2, 3, 4}");
    ASSERT_TRUE(start("eigen_matrix"));
    EXPECT_TRUE(run("v = eigen_matrix(2, 3)"));
    EXPECT_EQ(text(), "{{0, 0, 0}, {0, 0, 0}}");
}

TEST_P(AdaptedEigen, StorageIsAligned) {
    ASSERT_TRUE(start("/demo/Filter"));
    const SourcePtr state = value->getMember("state");
    ASSERT_TRUE(state);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(state->getRawPointer()) % 16, 0U);
    EXPECT_TRUE(run("v.state[3] = 2.0; v.attitude.w = 1.0; v.pose[0][3] = 7.0"));
}

TEST_P(AdaptedKdl, AFrameIsReachedThroughItsMembers) {
    ASSERT_TRUE(start("KDL.Frame"));
    EXPECT_TRUE(run("v.p.x = 1.0; v.p.Z = 3.0; v.M.Y_x = 0.5"));
    EXPECT_EQ(
        text(),
        "{p = {x = 1, y = 0, z = 3}, M = {X_x = 1, Y_x = 0.5, Z_x = 0, X_y = 0, Y_y = 1, Z_y = 0, X_z = 0, Y_z = 0, "
        "Z_z = 1}}");
}

TEST_P(AdaptedKdl, ScriptsMakeValuesOfNumbers) {
    ASSERT_TRUE(start("KDL.Frame"));
    EXPECT_TRUE(run("v = KDL.Frame(KDL.Rotation(0, 0, 1.5707963267948966), KDL.Vector(1, 2, 3))"));
    EXPECT_EQ(value->getMember("p")->toString(), "{x = 1, y = 2, z = 3}");
    const SourcePtr member = value->getMember("M")->getMember("Y_x");
    auto* const part = RTT::internal::DataSource<double>::narrow(member.get());
    ASSERT_TRUE(part);
    EXPECT_NEAR(part->get(), -1, 1e-9);
    EXPECT_TRUE(run("var KDL.Vector w = KDL.Vector(1, 2, 3); v.p = w"));
    EXPECT_FALSE(run("v.p = KDL.Vector(1, 2)"));
}

TEST_P(AdaptedKdl, TwistsAndWrenchesAreMadeOfVectors) {
    ASSERT_TRUE(start("KDL.Wrench"));
    EXPECT_TRUE(run("v = KDL.Wrench(KDL.Vector(1, 0, 0), KDL.Vector(0, 2, 0))"));
    EXPECT_EQ(text(), "{force = {x = 1, y = 0, z = 0}, torque = {x = 0, y = 2, z = 0}}");
    ASSERT_TRUE(typeOf("KDL.Twist").buildValue()->getMember("vel"));
}

TEST_P(AdaptedKdl, AJacobianHasSixRows) {
    ASSERT_TRUE(start("KDL.Jacobian"));
    RTT::PropertyBag bag;
    for (int i = 0; i != 6; ++i) addRow(bag, "row" + std::to_string(i), {double(i), 1});
    EXPECT_TRUE(compose(bag, value));
    EXPECT_EQ(text(), "{{0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 1}, {5, 1}}");
    RTT::PropertyBag five;
    for (int i = 0; i != 5; ++i) addRow(five, "row" + std::to_string(i), {1});
    EXPECT_FALSE(compose(five, value));
}

// Builds of sanitizers, and machines without these libraries, have no such typekit.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(AdaptedEigen);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(AdaptedKdl);
INSTANTIATE_TEST_SUITE_P(Golden, AdaptedLibrary, testing::ValuesIn(only("adapters")), test::caseName);
INSTANTIATE_TEST_SUITE_P(Golden, AdaptedEigen, testing::ValuesIn(only("eigen")), test::caseName);
INSTANTIATE_TEST_SUITE_P(Golden, AdaptedKdl, testing::ValuesIn(only("kdl")), test::caseName);
