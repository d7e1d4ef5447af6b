// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Variables, members, elements, constructors, assignments.
#include "script_fixture.hpp"

#include <rtt/ConnPolicy.hpp>
#include <rtt/os/TimeService.hpp>

#include <limits>
#include <vector>

using namespace RTT;

namespace {
class Expression : public ScriptTest {};
}  // namespace

TEST_F(Expression, Texts) {
    EXPECT_EQ(result<std::string>("string", "\"a\" + \"b\" + 3 + true + 1.5"), "ab3true1.5");
    EXPECT_TRUE(result<bool>("bool", "\"abc\" < \"abd\""));
    EXPECT_EQ(result<std::string>("string", "string(3)"), std::string(3, '\0'));
}

TEST_F(Expression, AssignmentsChainAndConvert) {
    ASSERT_TRUE(run("var int i, j = 4\nvar double d\nd = i = j + 1")) << messages();
    EXPECT_EQ(value<int>("i"), 5);
    EXPECT_EQ(value<double>("d"), 5.0);
}

TEST_F(Expression, AVariableMayBeInItsOwnValue) {
    ASSERT_TRUE(run("var double x = 2.0, y = 1.0\nx = x * 1.5 + y\nx = x - x * x")) << messages();
    EXPECT_EQ(value<double>("x"), -12.0);
}

TEST_F(Expression, MembersOfStructs) {
    ASSERT_TRUE(
        run("var ConnPolicy p\np.type = BUFFER\np.size = 2 + 3\np.name_id = \"/topic\"\nvar int n = p.size * 2"))
        << messages();
    EXPECT_EQ(value<ConnPolicy>("p").size, 5);
    EXPECT_EQ(std::string(value<ConnPolicy>("p").name_id), "/topic");
    EXPECT_EQ(value<int>("n"), 10);
}

TEST_F(Expression, ElementsOfSequences) {
    ASSERT_TRUE(
        run("var array a(3)\nvar int i = 1\na[i] = 2\na[i + 1] = a[1] * 2.5\nvar double last = a[2]\n"
            "var int n = a.size"))
        << messages();
    EXPECT_EQ(value<std::vector<double>>("a"), (std::vector<double>{0, 2, 5}));
    EXPECT_EQ(value<double>("last"), 5.0);
    EXPECT_EQ(value<int>("n"), 3);
}

TEST_F(Expression, AnIndexIsEvaluatedOnce) {
    int calls = 0;
    component.addOperation("next", [&calls] { return ++calls; });
    ASSERT_TRUE(run("var array a(5)\na[next()] = 7.0\nvar double x = a[next()] = 1.5\ntry a[next()] = 3.0"))
        << messages();
    EXPECT_EQ(calls, 3);
    EXPECT_EQ(value<std::vector<double>>("a"), (std::vector<double>{0, 7, 1.5, 3, 0}));
}

TEST_F(Expression, NumbersBeyondTheRangeOfATypeGiveItsLimits) {
    EXPECT_EQ(result<int>("int", "1e10"), std::numeric_limits<int>::max());
    ASSERT_TRUE(run("var double d = -1e30\nvar int i = d\nvar ullong u = d\nd = 0.0 / 0.0\nvar llong l = d"));
    EXPECT_EQ(value<int>("i"), std::numeric_limits<int>::min());
    EXPECT_EQ(value<unsigned long long>("u"), 0u);
    EXPECT_EQ(value<long long>("l"), 0);
}

TEST_F(Expression, AnAliasMayHideWhatItStandsFor) {
    ASSERT_TRUE(run("var int x = 5\nvar int seen\nprogram p { alias int x = x + 1\n seen = x }")) << messages();
    EXPECT_EQ(value<int>("seen"), 6);
}

TEST_F(Expression, Constructors) {
    EXPECT_EQ(result<std::vector<double>>("array", "array(1.0, 2.5)"), (std::vector<double>{1, 2.5}));
    EXPECT_EQ(result<double>("double", "double(7) / 2"), 3.5);
    EXPECT_EQ(result<double>("double", "array(1.0, 2.5)[1]"), 2.5);
    EXPECT_EQ(result<int>("int", "ConnPolicy().size"), ConnPolicy().size);
}

TEST_F(Expression, ConstructorsThatDoNotExist) {
    EXPECT_FALSE(run("var ConnPolicy p = ConnPolicy(true, \"x\")"));
    EXPECT_EQ(messages(), "script.ops:1:20: error: [OPS146] there is no constructor ConnPolicy(bool, string)\n");
}

TEST_F(Expression, CurrentTime) {
    const double before = static_cast<double>(os::TimeService::Instance()->getNSecs()) * 1e-9;
    const double told = result<double>("double", "time");
    EXPECT_GE(told, before);
    EXPECT_LT(told, before + 60);
}

TEST_F(Expression, ConstantsKeepTheValueOfTheirDeclaration) {
    ASSERT_TRUE(run("var int counter = 3\nconst int c = counter\ncounter = 9\nvar int x = c + 1")) << messages();
    EXPECT_EQ(value<int>("x"), 4);
    EXPECT_FALSE(run("c = 5"));
    EXPECT_EQ(messages(), "script.ops:1:1: error: [OPS127] this is a constant or a result and cannot be assigned to\n");
}

TEST_F(Expression, AliasesAreEvaluatedWithEachUse) {
    ASSERT_TRUE(run("var int i = 1\nalias int twice = i * 2\ni = 21\nvar int x = twice")) << messages();
    EXPECT_EQ(value<int>("x"), 42);
    EXPECT_FALSE(run("alias double wrong = i"));
    EXPECT_EQ(messages(), "script.ops:1:22: error: [OPS118] alias 'wrong' is for a value of type double, found int\n");
}

TEST_F(Expression, WhatDoesNotFit) {
    EXPECT_FALSE(run("var int i\ni = \"text\""));
    EXPECT_EQ(messages(), "script.ops:2:5: error: [OPS128] expected a value of type int for 'i', found string\n");
    EXPECT_FALSE(run("var string s = 1.5"));
    EXPECT_EQ(messages(),
              "script.ops:1:16: error: [OPS128] expected a value of type string for variable 's', found double\n");
    EXPECT_FALSE(run("var ConnPolicy p\np.sizes = 3"));
    EXPECT_EQ(messages(),
              "script.ops:2:3: error: [OPS123] type ConnPolicy has no member 'sizes'; did you mean 'size'?\n");
    EXPECT_FALSE(run("var int k = 3\nvar int l = k[0]"));
    EXPECT_EQ(messages(),
              "script.ops:2:13: error: [OPS124] a value of type int has no elements that an index of type "
              "int selects\n");
}

TEST_F(Expression, Declarations) {
    EXPECT_FALSE(run("var sting s"));
    EXPECT_EQ(messages(), "script.ops:1:5: error: [OPS110] type 'sting' is unknown; did you mean 'string'?\n");
    EXPECT_FALSE(run("var int twice\nvar double twice"));
    EXPECT_EQ(messages(), "script.ops:2:12: error: [OPS111] 'twice' is already declared in the script\n");
    EXPECT_FALSE(run("var array a(-2)"));
    EXPECT_EQ(messages(),
              "script.ops:1:13: error: [OPS114] 'a' cannot have -2 elements; the number is computed once, "
              "before the script runs\n");
    EXPECT_FALSE(run("var array b(\"x\")"));
    EXPECT_EQ(messages(),
              "script.ops:1:13: error: [OPS112] expected a number of elements (int) for 'b', found a value "
              "of type string; write '= array(...)' to use a constructor\n");
}
