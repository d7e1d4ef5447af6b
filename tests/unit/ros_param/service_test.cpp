// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Names, sub-services and what stays.
#include "param_fixture.hpp"

namespace param_test {

class ParameterService : public WithMaster {};
using oroforge::test::RosMaster;
using ::testing::HasSubstr;

struct Place {
    const char* policy;
    const char* prefix;
};
constexpr Place places[] = {
    {"Relative", "/"},
    {"Absolute", "/"},
    {"Private", "/n/"},
    {"ComponentPrivate", "/n/c/"},
    {"ComponentRelative", "/c/"},
    {"ComponentAbsolute", "/c/"},
};

TEST_F(ParameterService, SixPolicies) {
    int value = 0;
    component_.addProperty("policy_value", value);
    unsigned policy = 0;
    for (const Place& place : places) {
        const std::string full = std::string(place.prefix) + "policy_value";
        int there = 0;
        value = 11;
        EXPECT_TRUE(call(component_, "set" + std::string(place.policy), std::string("policy_value"))) << log_.take();
        EXPECT_TRUE(ros::param::get(full, there) && there == 11) << place.policy;
        value = 12;
        EXPECT_TRUE(call(component_, "setAll" + std::string(place.policy))) << log_.take();
        EXPECT_TRUE(ros::param::get(full, there) && there == 12) << place.policy;
        value = 13;
        EXPECT_TRUE(call(component_, "set", std::string("policy_value"), policy)) << log_.take();
        EXPECT_TRUE(ros::param::get(full, there) && there == 13) << place.policy;

        ros::param::set(full, 21);
        EXPECT_TRUE(call(component_, "get" + std::string(place.policy), std::string("policy_value"))) << log_.take();
        EXPECT_EQ(21, value) << place.policy;
        ros::param::set(full, 22);
        EXPECT_TRUE(call(component_, "getAll" + std::string(place.policy))) << log_.take();
        EXPECT_EQ(22, value) << place.policy;
        ros::param::set(full, 23);
        EXPECT_TRUE(call(component_, "get", std::string("policy_value"), policy++)) << log_.take();
        EXPECT_EQ(23, value) << place.policy;
        ros::param::del(full);
        EXPECT_FALSE(call(component_, "get" + std::string(place.policy), std::string("policy_value")));
    }
    EXPECT_FALSE(call(component_, "get", std::string("policy_value"), 6u));
    EXPECT_THAT(log_.take(), HasSubstr("6 is no policy"));
    EXPECT_FALSE(call(component_, "set", std::string("policy_value"), 6u));
}

TEST_F(ParameterService, ConstantsForScripts) {
    const auto service = component_.provides("rosparam");
    const std::pair<const char*, int> all[] = {{"RELATIVE", 0},          {"ABSOLUTE", 1},  {"PRIVATE", 2},
                                               {"COMPONENT_PRIVATE", 3}, {"COMPONENT", 3}, {"COMPONENT_RELATIVE", 4},
                                               {"COMPONENT_ABSOLUTE", 5}};
    for (const auto& [name, number] : all) {
        auto* const constant = service->getValue(name);
        ASSERT_NE(nullptr, constant) << name;
        EXPECT_EQ(number, types_test::valueOf<int>(constant->getDataSource()));
    }
}

TEST_F(ParameterService, AnyName) {
    int value = 5;
    component_.addProperty("p", value);
    EXPECT_TRUE(call(component_, "setParam", std::string("/n/else/where"), std::string("p"))) << log_.take();
    EXPECT_EQ("5\n", RosMaster::tool({"rosparam", "get", "/n/else/where"}).out);
    EXPECT_EQ(0, RosMaster::tool({"rosparam", "set", "/n/else/where", "7"}).status);
    EXPECT_TRUE(call(component_, "getParam", std::string("~else/where"), std::string("p"))) << log_.take();
    EXPECT_EQ(7, value);
    ros::param::set("/n/space/p", 8);
    EXPECT_TRUE(call(component_, "getParams", std::string("/n/space"))) << log_.take();
    EXPECT_EQ(8, value);
    EXPECT_FALSE(call(component_, "getParams", std::string("/n/nothing")));
    EXPECT_FALSE(call(component_, "getParams", std::string("/n/space/p"))) << "it is no namespace";
    EXPECT_THAT(log_.take(), HasSubstr("is an int (8)"));
    EXPECT_FALSE(call(component_, "getParam", std::string("/n/space/p"), std::string("q")));
    EXPECT_THAT(log_.take(), HasSubstr("no property and no service of the name 'q'"));
}

TEST_F(ParameterService, MalformedNames) {
    int value = 5;
    component_.addProperty("a b", value);
    component_.addProperty("p", value);
    for (const char* name : {"a b", "1x", "-", "a:b"}) {
        EXPECT_FALSE(call(component_, "getParam", std::string(name), std::string("p"))) << name;
        EXPECT_FALSE(call(component_, "setParam", std::string(name), std::string("p"))) << name;
        EXPECT_FALSE(call(component_, "getParams", std::string(name))) << name;
        EXPECT_THAT(log_.take(), HasSubstr("is not a name for a parameter")) << name;
    }
    EXPECT_FALSE(call(component_, "setRelative", std::string("a b")));
    component_.addProperty("a-b", value);
    (void)log_.take();
    EXPECT_FALSE(call(component_, "setAll"));
    EXPECT_THAT(log_.take(), HasSubstr("'a-b' cannot be the name of a parameter")) << "roscpp refuses it";
    RTT::TaskContext odd("my-component");
    ASSERT_TRUE(odd.loadService("rosparam"));
    EXPECT_FALSE(call(odd, "getAll"));
    EXPECT_FALSE(call(odd, "setAll"));
    EXPECT_THAT(log_.take(), HasSubstr("'~my-component' is not a name for a parameter"));
}

TEST_F(ParameterService, SubServices) {
    int top = 1, inner = 2, deep = 3, other = 4;
    component_.addProperty("top", top);
    component_.provides("arm")->addProperty("inner", inner);
    component_.provides("arm")->provides("hand")->addProperty("deep", deep);
    component_.provides("leg")->addProperty("other", other);
    EXPECT_TRUE(call(component_, "setAll")) << log_.take();
    Value there;
    ASSERT_TRUE(ros::param::get("/n/c", there));
    EXPECT_EQ(Value(2), there["arm"]["inner"]);
    EXPECT_EQ(Value(3), there["arm"]["hand"]["deep"]);
    there["top"] = 10;
    there["arm"]["hand"]["deep"] = 30;
    there["arm"]["inner"] = "wrong";
    there["leg"] = "wrong";
    ros::param::set("/n/c", there);
    EXPECT_TRUE(call(component_, "getAll")) << "failures of services do not count";
    EXPECT_THAT(log_.take(), AllOf(HasSubstr("/n/c/arm/inner"), HasSubstr("/n/c/leg")));
    EXPECT_EQ(10, top);
    EXPECT_EQ(2, inner);
    EXPECT_EQ(30, deep);
    EXPECT_EQ(4, other);

    inner = 20;
    EXPECT_TRUE(call(component_, "setComponentPrivate", std::string("arm"))) << log_.take();
    EXPECT_TRUE(ros::param::get("/n/c/arm", there));
    EXPECT_EQ(Value(20), there["inner"]);
    ros::param::set("/n/c/arm/inner", 21);
    EXPECT_TRUE(call(component_, "getComponentPrivate", std::string("arm"))) << log_.take();
    EXPECT_EQ(21, inner);
    EXPECT_FALSE(call(component_, "getComponentPrivate", std::string("leg"))) << "asked for, it does count";
}

TEST_F(ParameterService, ForeignParametersStay) {
    int a = 1;
    component_.addProperty("a", a);
    ros::param::set("/n/c/foreign", 9);
    ros::param::set("/n/c/rosparam/deep", 9);
    EXPECT_TRUE(call(component_, "setAll")) << log_.take();
    EXPECT_TRUE(ros::param::has("/n/c/foreign"));
    EXPECT_TRUE(ros::param::has("/n/c/rosparam/deep"));
    EXPECT_TRUE(call(component_, "setAllAbsolute")) << log_.take();
    EXPECT_TRUE(ros::param::has("/n/c/foreign"));
    EXPECT_TRUE(ros::param::has("/a"));
    ros::param::del("/a");
}

TEST_F(ParameterService, AParameterThatChangesItsType) {
    int a = 1, b = 1;
    component_.addProperty("a", a);
    component_.addProperty("b", b);
    EXPECT_FALSE(call(component_, "getAll")) << "there is no namespace";
    EXPECT_EQ("", log_.take()) << "only to be seen with the level Debug";
    ros::param::set("/n/c/a", 2);
    EXPECT_TRUE(call(component_, "getAll"));
    ros::param::set("/n/c/a", "text");
    ros::param::set("/n/c/b", 3);
    EXPECT_FALSE(call(component_, "getAll"));
    EXPECT_EQ(2, a);
    EXPECT_EQ(3, b) << "the others are set";
    a = 5;
    EXPECT_TRUE(call(component_, "setAll"));
    a = 0;
    EXPECT_TRUE(call(component_, "getAll"));
    EXPECT_EQ(5, a);
}

}  // namespace param_test
