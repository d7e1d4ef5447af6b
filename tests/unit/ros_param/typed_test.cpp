// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Operations for single values.
#include "param_fixture.hpp"

#include <Eigen/Core>

namespace param_test {

class TypedParameter : public WithMaster {
protected:
    template <class T>
    void setsAndGets(const std::string& type, const T& value) {
        for (const char* policy :
             {"", "Relative", "Absolute", "Private", "ComponentPrivate", "ComponentRelative", "ComponentAbsolute"}) {
            const auto service = component_.provides("rosparam");
            RTT::OperationCaller<void(const std::string&, const T&)> set(service->getOperation("set" + type + policy));
            RTT::OperationCaller<bool(const std::string&, T&)> get(service->getOperation("get" + type + policy));
            ASSERT_TRUE(set.ready() && get.ready()) << type << policy;
            T there{};
            EXPECT_FALSE(get("typed" + type, there)) << type << policy;
            set("typed" + type, value);
            EXPECT_TRUE(get("typed" + type, there)) << type << policy << log_.take();
            EXPECT_EQ(value, there) << type << policy;
            for (const char* prefix : {"/", "/n/", "/n/c/", "/c/"}) ros::param::del(prefix + ("typed" + type));
        }
    }
};
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST_F(TypedParameter, AllTypes) {
    setsAndGets<std::string>("String", "ü");
    setsAndGets<double>("Double", 0.1);
    setsAndGets<float>("Float", 0.5f);
    setsAndGets<int>("Int", -3);
    setsAndGets<bool>("Bool", true);
    setsAndGets<std::vector<std::string>>("VectorOfString", {"a", "b"});
    setsAndGets<std::vector<double>>("VectorOfDouble", {0.1, 2});
    setsAndGets<std::vector<float>>("VectorOfFloat", {0.5f, 2});
    setsAndGets<std::vector<int>>("VectorOfInt", {1, 2});
    setsAndGets<std::vector<bool>>("VectorOfBool", {true, false});
    setsAndGets<Eigen::VectorXd>("EigenVectorXd", Eigen::Vector2d(0.1, 2));
    setsAndGets<Eigen::VectorXf>("EigenVectorXf", Eigen::Vector2f(0.5f, 2));
}

TEST_F(TypedParameter, WhatDoesNotFit) {
    RTT::OperationCaller<bool(const std::string&, std::vector<int>&)> get(
        component_.provides("rosparam")->getOperation("getVectorOfIntPrivate"));
    ros::param::set("/n/v", array(1, 2.5));
    std::vector<int> values{7, 8};
    EXPECT_FALSE(get("v", values));
    EXPECT_THAT(values, ElementsAre(7, 8));
    EXPECT_THAT(log_.take(), HasSubstr("'/n/v[1]' is a double (2.5)"));
    EXPECT_FALSE(get("no name", values));
}

}  // namespace param_test
