// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The parameters that values become.
#include "param_fixture.hpp"

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace param_test {

class SetParameter : public WithMaster {};
using oroforge::test::RosMaster;
using ::testing::HasSubstr;

TEST_F(SetParameter, SimpleValues) {
    EXPECT_EQ(Value("grün <✓> & ' "), made<std::string>("grün <✓> & ' "));
    EXPECT_EQ(Value(""), made<std::string>(""));
    EXPECT_EQ(Value(true), made(true));
    EXPECT_EQ(Value(0.1), made(0.1));
    EXPECT_EQ(Value(1e-300), made(1e-300));
    EXPECT_EQ(Value(-1.7976931348623157e308), made(-1.7976931348623157e308));
    EXPECT_EQ(Value(0.5), made(0.5f));
    EXPECT_EQ(Value(-3), made(-3));
    EXPECT_EQ(Value(3), made(3u));
    EXPECT_EQ(Value(65), made('A'));
    EXPECT_EQ(Value(200), made<unsigned char>(200));
    EXPECT_EQ(Value(-7), made(-7ll));
    EXPECT_EQ(Value("Filling"), made(sample::Mode::Filling));
    EXPECT_EQ(Value(3), made(static_cast<sample::Mode>(3)));
    EXPECT_EQ(Value(2147483647), made(2147483647u));
    const Value number = made(std::nan(""));
    ASSERT_EQ(Value::TypeDouble, number.getType());
    EXPECT_TRUE(std::isnan(static_cast<const double&>(number)));
    EXPECT_EQ(Value(std::numeric_limits<double>::infinity()), made(std::numeric_limits<double>::infinity()));
    EXPECT_EQ("", log_.take());
}

TEST_F(SetParameter, WhatTheServerCannotHold) {
    EXPECT_FALSE(made(3000000000u, false).valid());
    EXPECT_THAT(log_.take(), AllOf(HasSubstr("3000000000 does not fit into the 32 bits"), HasSubstr("'/n/c/p'")));
    EXPECT_FALSE(made(-3000000000ll, false).valid());
    EXPECT_FALSE(made(~0ull, false).valid());
    EXPECT_FALSE(made(std::vector<unsigned>{1, 3000000000u}, false).valid());
    EXPECT_THAT(log_.take(), HasSubstr("'/n/c/p[1]'"));
    EXPECT_FALSE(made(std::string("a\0b", 3), false).valid());
    EXPECT_FALSE(made<std::string>("\xff", false).valid());
    EXPECT_THAT(log_.take(), HasSubstr("not UTF-8"));
    int value = 1;
    component_.addProperty("a/b", value);
    EXPECT_FALSE(call(component_, "setAll"));
    EXPECT_THAT(log_.take(), HasSubstr("'a/b' cannot be the name of a parameter"));
}

TEST_F(SetParameter, Sequences) {
    EXPECT_EQ(array(1.0, 2.5), made(std::vector<double>{1, 2.5}));
    EXPECT_EQ(array(0.5), made(std::vector<float>{0.5f}));
    EXPECT_EQ(array(1, 2), made(std::vector<int>{1, 2}));
    EXPECT_EQ(array(1, 2), made(std::vector<unsigned>{1, 2}));
    EXPECT_EQ(array(65), made(std::vector<char>{'A'}));
    EXPECT_EQ(array(255), made(std::vector<unsigned char>{255}));
    EXPECT_EQ(array(true, false), made(std::vector<bool>{true, false}));
    EXPECT_EQ(array("a", ""), made(std::vector<std::string>{"a", ""}));
    EXPECT_EQ(array(1.0, 2.5), made<Eigen::VectorXd>(Eigen::Vector2d(1, 2.5)));
    EXPECT_EQ(array(1.0, 2.5), made<Eigen::VectorXf>(Eigen::Vector2f(1, 2.5f)));
    const Value empty = made(std::vector<int>());
    EXPECT_EQ(Value::TypeArray, empty.getType());
    EXPECT_EQ(0, empty.size());
}

TEST_F(SetParameter, StructsMemberByMember) {
    sample::Tank tank;
    tank.id = 3;
    tank.mode = sample::Mode::Filling;
    tank.path = {{1, 2}};
    tank.flags = {true};
    component_.addProperty("tank", tank);
    ros::param::set("/n/c/tank/position/z", 5);
    EXPECT_TRUE(call(component_, "setAll")) << log_.take();
    Value there;
    ASSERT_TRUE(ros::param::get("/n/c/tank", there));
    EXPECT_EQ(Value(3), there["id"]);
    EXPECT_EQ(Value("Filling"), there["mode"]);
    EXPECT_EQ(Value(1.0), there["path"][0]["x"]);
    EXPECT_EQ(array(0.0, 0.0, 0.0), there["weights"]);
    EXPECT_EQ(array(0, 0), there["pair"]);
    EXPECT_EQ(array(true), there["flags"]);
    EXPECT_EQ(Value(5), there["position"]["z"]) << "foreign parameters stay";
    const auto shown = RosMaster::tool({"rosparam", "get", "/n/c/tank/path"});
    EXPECT_EQ("- x: 1.0\n  y: 2.0\n\n", shown.out) << shown.err;
}

TEST_F(SetParameter, BagsAndEmptyOnes) {
    int a = 1;
    RTT::PropertyBag bag, empty;
    bag.addProperty("a", a);
    bag.addProperty("empty", empty);
    component_.addProperty("bag", bag);
    EXPECT_TRUE(call(component_, "setAll")) << log_.take();
    Value there;
    ASSERT_TRUE(ros::param::get("/n/c/bag", there));
    EXPECT_EQ(Value(1), there["a"]);
    EXPECT_EQ(Value::TypeStruct, there["empty"].getType());
    ros::param::set("/n/c/bag/empty/foreign", 2);
    EXPECT_TRUE(call(component_, "setAll")) << log_.take();
    EXPECT_TRUE(ros::param::has("/n/c/bag/empty/foreign")) << "foreign parameters stay";
    ros::param::set("/n/c/bag", 3);
    EXPECT_TRUE(call(component_, "setAll")) << log_.take();
    EXPECT_TRUE(ros::param::has("/n/c/bag/a")) << "a value that is no struct is replaced";
}

TEST_F(SetParameter, OneThatCannotBeSetDoesNotHinderOthers) {
    unsigned big = 3000000000u;
    int good = 4;
    component_.addProperty("big", big);
    component_.addProperty("good", good);
    EXPECT_FALSE(call(component_, "setAll"));
    int there = 0;
    EXPECT_TRUE(ros::param::get("/n/c/good", there));
    EXPECT_EQ(4, there);
}

}  // namespace param_test
