// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Enumerators by their names in scripts; property files are in typekit_values_test.cpp.
#include <memory>

#include <rtt/Attribute.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/scripting/ScriptingService.hpp>

#include "golden_typekit.hpp"

using namespace oroforge;

namespace {

/// Scripts with the variables "v", a struct with a mode that is Idle or Busy, and "s", a string.
class EnumNames : public test::GoldenTypekit {
protected:
    void SetUp() override {
        test::GoldenTypekit::SetUp();
        value = typeOf("/enum_and_nested/State").buildValue();
        variable.reset(typeOf("/enum_and_nested/State").buildAttribute("v", value));
        component.addAttribute(*variable);
        component.addAttribute(text);
    }
    void TearDown() override { component.provides()->clear(); }
    std::string mode() const { return value->getMember("mode")->toString(); }

    RTT::TaskContext component{"component"};
    RTT::scripting::ScriptingService scripts{&component};
    RTT::base::DataSourceBase::shared_ptr value;
    std::unique_ptr<RTT::base::AttributeBase> variable;
    RTT::Attribute<std::string> text{"s", ""};
};

}  // namespace

TEST_P(EnumNames, AreAssigned) {
    EXPECT_TRUE(scripts.eval("v.mode = \"Busy\""));
    EXPECT_EQ(mode(), "Busy");
    EXPECT_TRUE(scripts.eval("v.mode = 0"));
    EXPECT_EQ(mode(), "Idle");
    EXPECT_TRUE(scripts.eval("s = \"Busy\"; v.mode = s"));
    EXPECT_EQ(mode(), "Busy");
}

TEST_P(EnumNames, UnknownOnesChangeNothing) {
    EXPECT_TRUE(scripts.eval("v.mode = \"Busy\""));
    EXPECT_FALSE(scripts.eval("v.mode = \"Bussy\""));
    EXPECT_EQ(mode(), "Busy");
}

TEST_P(EnumNames, AreMadeOfValues) {
    EXPECT_TRUE(scripts.eval("v.mode = 1; s = string(v.mode)"));
    EXPECT_EQ(text.get(), "Busy");
}

TEST_P(EnumNames, AreCompared) {
    EXPECT_TRUE(scripts.eval("v.mode = 1; if (v.mode == \"Busy\") then s = \"busy\""));
    EXPECT_EQ(text.get(), "busy");
    EXPECT_TRUE(scripts.eval("if (v.mode != \"Busy\") then s = \"not busy\""));
    EXPECT_EQ(text.get(), "busy");
    EXPECT_TRUE(scripts.eval("if (1 == v.mode && v.mode == 1) then s = \"one\""));
    EXPECT_EQ(text.get(), "one");
}

INSTANTIATE_TEST_SUITE_P(Golden, EnumNames, testing::Values("enum_and_nested"));
