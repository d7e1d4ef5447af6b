// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ast_text.hpp"

#include <gtest/gtest.h>

namespace {

using tests::parsed;

TEST(ScriptDefinition, Functions) {
    EXPECT_EQ(parsed("function f { a; b }"), "local void f() { a; b }");
    EXPECT_EQ(parsed("function f() {}"), "local void f() {}");
    EXPECT_EQ(parsed("void f(void) { }"), "local void f() {}");
    EXPECT_EQ(parsed("double f(int a, /x/Y b(3)) { return a }"), "local double f(int a, /x/Y b(3)) { return a }");
    EXPECT_EQ(parsed("ints[] f() { }"), "local ints[] f() {}");
    EXPECT_EQ(parsed("double f\n{\n}"), "local double f() {}");
}

TEST(ScriptDefinition, FunctionsWithoutParenthesesMayHaveTypesThatResembleKeywords) {
    EXPECT_EQ(parsed("Friction f { }"), "local Friction f() {}");
}

TEST(ScriptDefinition, ScopesOfFunctions) {
    EXPECT_EQ(parsed("export ints[] f() { }"), "export ints[] f() {}");
    EXPECT_EQ(parsed("export function f {}"), "export void f() {}");
    EXPECT_EQ(parsed("global string f(string a) { return a + \"_x\" }"),
              "global string f(string a) { return (a + \"_x\") }");
    EXPECT_EQ(parsed("local void f() {}"), "local void f() {}");
}

TEST(ScriptDefinition, ArgumentsCanBeOfATypeVoid) { EXPECT_EQ(parsed("void f(void x) {}"), "local void f(void x) {}"); }

TEST(ScriptDefinition, Programs) {
    EXPECT_EQ(parsed("program p { var int i = 0; while true { set i = i + 1; yield } }"),
              "program p { var int i = 0; while true { (i = (i + 1)); yield } }");
    EXPECT_EQ(parsed("program p\n{\n}\n"), "program p {}");
}

TEST(ScriptDefinition, RootMachines) {
    EXPECT_EQ(parsed("RootMachine T m"), "RootMachine T m()");
    EXPECT_EQ(parsed("RootMachine T m()"), "RootMachine T m()");
    EXPECT_EQ(parsed("RootMachine T m (p = 1, q = a + b)"), "RootMachine T m(p = 1, q = (a + b))");
    EXPECT_EQ(parsed("RootMachine T m\nm.activate()"), "RootMachine T m() ; m.activate()");
}

TEST(ScriptDefinition, StandInAnyOrderWithStatements) {
    EXPECT_EQ(parsed("a\nprogram p { }\nb\nvoid f() { } program q { } c"),
              "a ; program p {} ; b ; local void f() {} ; program q {} ; c");
}

TEST(ScriptDefinition, CallsOfTheSameWordsAreStatements) {
    EXPECT_EQ(parsed("a\nb()\n"), "a ; b()");
    EXPECT_EQ(parsed("X.configure\nf (1)"), "X.configure ; f(1)");
    EXPECT_EQ(parsed("function.x = 1"), "(function.x = 1)");
}

}  // namespace
