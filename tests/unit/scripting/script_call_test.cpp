// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calls of operations and functions.
#include "script_fixture.hpp"

#include <stdexcept>

using namespace RTT;

namespace {

class Calls : public ScriptTest {
protected:
    Calls() : arm("arm") {
        component.addOperation("add", [](int a, double b) { return a + b; });
        component.addOperation("note", [this](const std::string& text) { noted += text + ";"; });
        component.addOperation("refuse", []() -> bool { return false; });
        component.addOperation("fails", []() -> int { throw std::runtime_error("no hardware"); });
        component.addOperation("fill", [](int& into) { into = 42; });
        arm.provides("control")->addOperation("move", [this](double to) { return position = to, true; });
        component.connectPeers(&arm);
    }

    std::string noted;
    double position = 0;
    TaskContext arm;
};

}  // namespace

TEST_F(Calls, ArgumentsAreConvertedAndResultsUsed) {
    EXPECT_EQ(result<double>("double", "add(1, 2)"), 3.0);
    EXPECT_EQ(result<double>("double", "add(1, add(2, 3.5)) * 2"), 13.0);
    ASSERT_TRUE(run("var int i = 2\nvar double d = add(i + 1, i)\nadd(1, 1)")) << messages();
    EXPECT_EQ(value<double>("d"), 5.0);
}

TEST_F(Calls, InOrderAndWithoutParentheses) {
    ASSERT_TRUE(run("note(\"a\" + 1); note(\"b\")\nrefuse\nthis.refuse\ndo note(\"c\")")) << messages();
    EXPECT_EQ(noted, "a1;b;c;");
}

TEST_F(Calls, OfServicesOfPeers) {
    ASSERT_TRUE(run("var bool ok = arm.control.move(3)")) << messages();
    EXPECT_TRUE(value<bool>("ok"));
    EXPECT_EQ(position, 3.0);
}

TEST_F(Calls, OutputArguments) {
    ASSERT_TRUE(run("var int x\nfill(x)")) << messages();
    EXPECT_EQ(value<int>("x"), 42);
    EXPECT_FALSE(run("fill(3)"));
    EXPECT_EQ(messages(),
              "script.ops:1:6: error: [OPS144] argument 1 of 'fill' is assigned by the call: expected a "
              "variable, found a value of type int\n");
}

TEST_F(Calls, WrongArguments) {
    EXPECT_FALSE(run("add(1)"));
    EXPECT_EQ(messages(), "script.ops:1:1: error: [OPS142] 'add' expects 2 arguments, found 1 argument\n");
    EXPECT_FALSE(run("add(1, \"x\")"));
    EXPECT_EQ(messages(), "script.ops:1:8: error: [OPS143] argument 2 of 'add' must be of type double, found string\n");
    EXPECT_FALSE(run("ad(1, 2)"));
    EXPECT_EQ(messages(),
              "script.ops:1:1: error: [OPS134] component 'robot' has no operation 'ad'; did you mean 'add'?\n");
}

TEST_F(Calls, ANumberWithAFractionForAWholeOneIsWarnedOf) {
    component.addOperation("plan", [](double period, int priority) { return period * priority; })
        .arg("Period", "")
        .arg("Priority", "");
    ASSERT_TRUE(run("plan(98, 0.5)"));
    EXPECT_EQ(messages(),
              "script.ops:1:10: warning: [OPS152] argument 2 (Priority) of 'plan' is a whole number (int): "
              "what is given loses its fraction\n");
    ASSERT_EQ(sink.all()[0].notes.size(), 1u);
    EXPECT_EQ(sink.all()[0].notes[0].message, "argument 1 (Period) is of type double: are the two swapped?");
}

TEST_F(Calls, ConversionsThatLoseSomethingAreToldWhereTheyAre) {
    ASSERT_TRUE(run("note(3)"));
    EXPECT_EQ(messages(),
              "script.ops:1:1: warning: [OPS120] a value of type int is converted to string and becomes a "
              "text of that many letters\n");
}

TEST_F(Calls, WhatAnOperationThrowsFailsTheStatement) {
    EXPECT_FALSE(run("note(\"before\")\nfails()\nnote(\"after\")"));
    EXPECT_EQ(noted, "before;");
    EXPECT_NE(messages().find("script.ops:2:1: error: [OPS400] "), std::string::npos) << messages();
    EXPECT_NE(messages().find("no hardware"), std::string::npos) << messages();
}

TEST_F(Calls, TryGoesOnAndCatches) {
    ASSERT_TRUE(
        run("try fails()\nnote(\"on\")\ntry fails() catch { note(\"caught\") }\ntry refuse() catch note(\"no\")"))
        << messages();
    EXPECT_EQ(noted, "on;caught;");
}

TEST_F(Calls, Functions) {
    ASSERT_TRUE(
        run("int sum(int a, int b) {\n  var int local\n  local = local + a + b\n  return local\n}\n"
            "void twice(string text) { note(text); note(text) }\n"
            "var int x = sum(1, sum(2, 3)) * 10 + sum(4, 5)\ntwice(\"t\")"))
        << messages();
    EXPECT_EQ(value<int>("x"), 69);
    EXPECT_EQ(noted, "t;t;");
}

TEST_F(Calls, FunctionsYieldAndReturnEarly) {
    ASSERT_TRUE(
        run("int wait(int n) {\n  while (true) {\n    if n == 0 then return 7\n    n = n - 1\n    yield\n  }\n}\n"
            "var int x = wait(3)"))
        << messages();
    EXPECT_EQ(value<int>("x"), 7);
    EXPECT_EQ(yields, 3);
}

TEST_F(Calls, FunctionsCannotCallThemselves) {
    EXPECT_FALSE(run("void f() { f() }\nf()"));
    EXPECT_NE(messages().find("script.ops:1:12: error: [OPS151] function 'f' calls itself"), std::string::npos)
        << messages();
}

TEST_F(Calls, FailuresWithinFunctionsTellWhere) {
    EXPECT_FALSE(run("void f() {\n  note(\"f\")\n  fails()\n}\nnote(\"x\")\nf()"));
    EXPECT_EQ(noted, "x;f;");
    EXPECT_NE(messages().find("script.ops:6:1: error: [OPS400] "), std::string::npos) << messages();
    EXPECT_NE(messages().find("(at script.ops:3:3, in function 'f')"), std::string::npos) << messages();
}

TEST_F(Calls, WrongReturns) {
    EXPECT_FALSE(run("void f() { return 3 }\nf()"));
    EXPECT_EQ(messages(),
              "script.ops:1:19: error: [OPS210] function 'f' returns nothing (void), but here it returns a "
              "value\n");
    EXPECT_FALSE(run("int g() { return \"x\" }\ng()"));
    EXPECT_EQ(messages(),
              "script.ops:1:18: error: [OPS128] expected a value of type int for the result of function "
              "'g', found string\n");
}

TEST_F(Calls, FunctionsWithoutReturnGiveTheDefaultValue) {
    ASSERT_TRUE(
        run("int f(bool b) { if b then return 5 }\nvar int a\nvar int b\n"
            "program p { a = f(true)\n b = f(false) }"))
        << messages();
    EXPECT_EQ(value<int>("a"), 5);
    EXPECT_EQ(value<int>("b"), 0);
}

TEST_F(Calls, OneErrorInAFunctionIsToldOnce) {
    EXPECT_FALSE(run("void f() { nosuch() }\nprogram p { f()\n f() }"));
    EXPECT_EQ(sink.errorCount(), 1u) << messages();
}

TEST_F(Calls, PeersOfTheComponentItself) {
    ASSERT_TRUE(run("this.arm.control.move(2)")) << messages();
    EXPECT_EQ(position, 2.0);
    ASSERT_TRUE(run("task.arm.control.move(3)")) << messages();
    EXPECT_EQ(position, 3.0);
}
