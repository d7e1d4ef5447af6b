// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Aliases of structs and enums are names of types in scripts; the type keeps its first name.
#include <rtt/TaskContext.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

#include "golden_typekit.hpp"

using namespace oroforge;

namespace {

class OtherNames : public test::GoldenTypekit {};

}  // namespace

TEST_P(OtherNames, DeclareVariables) {
    RTT::TaskContext component{"component"};
    RTT::scripting::ScriptingService scripts{&component};
    EXPECT_TRUE(
        scripts.eval("var enum_and_nested.Condition a; var enum_and_nested.Latest b; var EnumAndNestedState c"));
    EXPECT_TRUE(
        scripts.eval("var enum_and_nested.Condition a; var enum_and_nested.Latest b; var EnumAndNestedState c;"
                     "var enum_and_nested.Activity m = \"Busy\"; a.mode = m; b = a; c = b;"
                     "var enum_and_nested.State.Piece p; p.text = \"made\"; c.part = p"));
    component.provides()->clear();
}

TEST_P(OtherNames, LeaveTheFirstOneToTheType) {
    for (const char* name : {"/enum_and_nested/Condition", "/enum_and_nested/Latest", "/EnumAndNestedState"})
        EXPECT_EQ(typeOf(name).getTypeName(), "/enum_and_nested/State") << name;
    EXPECT_EQ(typeOf("/enum_and_nested/Activity").getTypeName(), "/enum_and_nested/Mode");
    EXPECT_EQ(typeOf("/enum_and_nested/State/Piece").getTypeName(), "/enum_and_nested/State/Part");
}

INSTANTIATE_TEST_SUITE_P(Golden, OtherNames, testing::Values("enum_and_nested"));
