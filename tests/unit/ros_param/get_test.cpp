// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What parameters fill which properties, and what not.
#include "param_fixture.hpp"

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace param_test {

class GetParameter : public WithMaster {};
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST_F(GetParameter, SimpleValues) {
    EXPECT_EQ("grün ✓", got<std::string>("grün ✓", ""));
    EXPECT_EQ("", got<std::string>("", "x"));
    EXPECT_EQ(" a <b> & \"c\"\n\td ", got<std::string>(" a <b> & \"c\"\n\td ", ""));
    EXPECT_TRUE(got<bool>(true, false));
    EXPECT_EQ(0.1, got<double>(0.1, 0));
    EXPECT_EQ(1e-300, got<double>(1e-300, 0));
    EXPECT_EQ(0.5f, got<float>(0.5, 0));
    EXPECT_EQ(3.0, got<double>(3, 0));
    EXPECT_EQ(3.0f, got<float>(3, 0));
    EXPECT_EQ(-3, got<int>(-3, 0));
    EXPECT_EQ(3u, got<unsigned>(3, 0));
    EXPECT_EQ('A', got<char>(65, 0));
    EXPECT_EQ(200, got<unsigned char>(200, 0));
    EXPECT_EQ(-7, got<long long>(-7, 0));
    EXPECT_EQ(7u, got<unsigned long long>(7, 0));
    EXPECT_EQ(-7, got<short>(-7, 0));
    EXPECT_TRUE(std::isnan(got<double>(std::nan(""), 0)));
    EXPECT_EQ(-std::numeric_limits<double>::infinity(), got<double>(-std::numeric_limits<double>::infinity(), 0));
    EXPECT_EQ("", log_.take());
}

TEST_F(GetParameter, WhatDoesNotFitLeavesTheValue) {
    EXPECT_EQ(5, got<int>(2.0, 5, false));
    EXPECT_THAT(log_.take(), HasSubstr("parameter '/n/c/p' is a double (2), which cannot be a value of type int"));
    EXPECT_EQ(5, got<int>(true, 5, false));
    EXPECT_EQ(5, got<int>("7", 5, false));
    EXPECT_TRUE(got<bool>(0, true, false));
    EXPECT_EQ("x", got<std::string>(1, "x", false));
    EXPECT_EQ(5, got<double>(true, 5, false));
    EXPECT_EQ(5u, got<unsigned>(-1, 5, false));
    EXPECT_THAT(log_.take(), HasSubstr("out of range"));
    EXPECT_EQ(5, got<unsigned char>(256, 5, false));
    EXPECT_EQ(5, got<char>(128, 5, false));
    EXPECT_EQ(5u, got<unsigned long long>(-1, 5, false));
    EXPECT_EQ(5.0f, got<float>(1e300, 5, false));
    EXPECT_EQ(5, got<int>(array(1), 5, false));
    Value data(const_cast<char*>("abc"), 3);
    EXPECT_EQ("x", got<std::string>(data, "x", false));
    EXPECT_THAT(log_.take(), HasSubstr("binary data"));
}

TEST_F(GetParameter, Sequences) {
    EXPECT_THAT(got<std::vector<double>>(array(1, 2.5), {}), ElementsAre(1, 2.5));
    EXPECT_THAT(got<std::vector<float>>(array(1, 2.5), {}), ElementsAre(1, 2.5f));
    EXPECT_THAT(got<std::vector<int>>(array(1, -2), {7, 7, 7}), ElementsAre(1, -2));
    EXPECT_THAT(got<std::vector<unsigned>>(array(1, 2), {}), ElementsAre(1u, 2u));
    EXPECT_THAT(got<std::vector<char>>(array(65), {}), ElementsAre('A'));
    EXPECT_THAT(got<std::vector<unsigned char>>(array(255), {}), ElementsAre(255));
    EXPECT_THAT(got<std::vector<bool>>(array(true, false), {}), ElementsAre(true, false));
    EXPECT_THAT(got<std::vector<std::string>>(array("a", ""), {}), ElementsAre("a", ""));
    EXPECT_TRUE(got<std::vector<int>>(array(), {1}).empty());
    const auto vector = got<Eigen::VectorXd>(array(1, 2.5), Eigen::VectorXd());
    EXPECT_EQ(Eigen::Vector2d(1, 2.5), vector);
    const auto floats = got<Eigen::VectorXf>(array(1, 2.5), Eigen::VectorXf::Zero(5));
    EXPECT_EQ(Eigen::Vector2f(1, 2.5f), floats);
    EXPECT_EQ("", log_.take());
}

TEST_F(GetParameter, NoHalfSequence) {
    EXPECT_THAT(got<std::vector<int>>(array(1, 2.5), {7, 8, 9}, false), ElementsAre(7, 8, 9));
    EXPECT_THAT(log_.take(), AllOf(HasSubstr("parameter '/n/c/p[1]' is a double (2.5)"), HasSubstr("property 'p'")));
    EXPECT_THAT(got<std::vector<std::string>>(array("a", 1), {"x"}, false), ElementsAre("x"));
    EXPECT_EQ(1, got<Eigen::VectorXd>(array(1, "a"), Eigen::VectorXd::Zero(1), false).size());
    EXPECT_THAT(got<std::vector<int>>(3, {7}, false), ElementsAre(7));
    sample::Tank tank;
    tank.pair = {8, 9};
    Value given;
    given["pair"] = array(1, 2, 3);
    EXPECT_THAT(got(given, tank, false).pair, ElementsAre(8, 9));
    EXPECT_THAT(log_.take(), HasSubstr("2 elements"));
}

TEST_F(GetParameter, StructsByTheirMembers) {
    Value given;
    given["id"] = 3;
    given["unknown"] = "is ignored";
    given["label"] = "t";
    given["position"]["x"] = 1;
    given["levels"] = array(0.5);
    Value point;
    point["y"] = 2.5;
    given["path"] = array(point, point);
    given["weights"] = array(1, 2, 3);
    given["pair"] = array(4, 5);
    given["mode"] = "Draining";
    given["small"] = 6;
    given["flags"] = array(true);
    sample::Tank before;
    before.position.y = 9;
    const sample::Tank tank = got(given, before);
    EXPECT_EQ(3, tank.id);
    EXPECT_EQ("t", tank.label);
    EXPECT_EQ(1, tank.position.x);
    EXPECT_EQ(9, tank.position.y) << "it is not in the parameter";
    EXPECT_THAT(tank.levels, ElementsAre(0.5));
    ASSERT_EQ(2u, tank.path.size());
    EXPECT_EQ(2.5, tank.path[1].y);
    EXPECT_EQ(3, tank.weights[2]);
    EXPECT_THAT(tank.pair, ElementsAre(4, 5));
    EXPECT_EQ(sample::Mode::Draining, tank.mode);
    EXPECT_EQ(6, tank.small);
    EXPECT_THAT(tank.flags, ElementsAre(true));

    given["path"] = array(point, 3);
    given["id"] = 4;
    const sample::Tank same = got(given, tank, false);
    EXPECT_EQ(3, same.id) << "all or nothing";
    EXPECT_THAT(log_.take(), HasSubstr("'/n/c/p/path[1]' is an int (3)"));
    Value nothing;
    (void)nothing.begin();
    EXPECT_EQ(3, got(nothing, tank).id);
}

TEST_F(GetParameter, Enumerators) {
    EXPECT_EQ(sample::Mode::Filling, got<sample::Mode>("Filling", sample::Mode::Idle));
    EXPECT_EQ(sample::Mode::Draining, got<sample::Mode>(7, sample::Mode::Idle));
    EXPECT_EQ(sample::Mode::Idle, got<sample::Mode>("Fast", sample::Mode::Idle, false));
    EXPECT_THAT(log_.take(), HasSubstr("it is none of Idle, Filling"));
    EXPECT_EQ(sample::Mode::Idle, got<sample::Mode>(3, sample::Mode::Idle, false));
}

TEST_F(GetParameter, BagsWithWhatTheyHave) {
    int a = 1;
    double b = 2;
    std::vector<int> c{3};
    RTT::PropertyBag inner, outer;
    inner.addProperty("b", b);
    inner.addProperty("c", c);
    outer.addProperty("a", a);
    outer.addProperty("inner", inner);
    component_.addProperty("bag", outer);
    Value given;
    given["a"] = 10;
    given["inner"]["b"] = 20;
    given["inner"]["c"] = array(30);
    given["inner"]["new"] = 1;
    ros::param::set("/n/c/bag", given);
    EXPECT_TRUE(call(component_, "getAll")) << log_.take();
    EXPECT_EQ(10, a);
    const auto* const inside = outer.getPropertyType<RTT::PropertyBag>("inner");
    EXPECT_EQ(2u, inside->rvalue().size()) << "nothing is created";
    EXPECT_EQ(20, b);
    EXPECT_THAT(c, ElementsAre(30));

    given["a"] = 11;
    given["inner"]["c"] = array("x");
    ros::param::set("/n/c/bag", given);
    EXPECT_FALSE(call(component_, "getAll"));
    EXPECT_EQ(10, a) << "all or nothing";
    EXPECT_THAT(log_.take(), HasSubstr("'/n/c/bag/inner/c[0]' is a string ('x')"));
    ros::param::set("/n/c/bag", 3);
    EXPECT_FALSE(call(component_, "getAll"));
    EXPECT_THAT(log_.take(), HasSubstr("PropertyBag"));
}

struct Unknown {};

TEST_F(GetParameter, TypesOfNoTypekit) {
    Unknown nothing;
    component_.addProperty("p", nothing);
    ros::param::set("/n/c/p", 3);
    EXPECT_FALSE(call(component_, "getAll"));
    EXPECT_THAT(log_.take(), AllOf(HasSubstr("param_test::Unknown"), HasSubstr("no typekit that is loaded")));
}

}  // namespace param_test
