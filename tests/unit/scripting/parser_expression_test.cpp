// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ast_text.hpp"

#include <gtest/gtest.h>

namespace {

using tests::parsed;

TEST(ScriptExpression, EachOperatorBindsMoreThanTheOneBefore) {
    EXPECT_EQ(parsed("a = b && c"), "(a = (b && c))");
    EXPECT_EQ(parsed("a && b || c"), "(a && (b || c))");
    EXPECT_EQ(parsed("a || b != c"), "(a || (b != c))");
    EXPECT_EQ(parsed("a != b == c"), "(a != (b == c))");
    EXPECT_EQ(parsed("a == b >= c"), "(a == (b >= c))");
    EXPECT_EQ(parsed("a >= b > c"), "(a >= (b > c))");
    EXPECT_EQ(parsed("a > b <= c"), "(a > (b <= c))");
    EXPECT_EQ(parsed("a <= b < c"), "(a <= (b < c))");
    EXPECT_EQ(parsed("a < b + c"), "(a < (b + c))");
    EXPECT_EQ(parsed("a + b % c"), "(a + (b % c))");
    EXPECT_EQ(parsed("a % b * c"), "(a % (b * c))");
    EXPECT_EQ(parsed("a * -b"), "(a * (-b))");
    EXPECT_EQ(parsed("-a.b"), "(-a.b)");
}

TEST(ScriptExpression, TheSameInTheOtherOrder) {
    EXPECT_EQ(parsed("a || b && c"), "((a || b) && c)");
    EXPECT_EQ(parsed("a == b != c"), "((a == b) != c)");
    EXPECT_EQ(parsed("a * b % c + d < e <= f > g >= h == i != j || k && l"),
              "(((((((((((a * b) % c) + d) < e) <= f) > g) >= h) == i) != j) || k) && l)");
}

TEST(ScriptExpression, OperatorsOfOneKindGoFromLeftToRight) {
    EXPECT_EQ(parsed("a - b + c - d"), "(((a - b) + c) - d)");
    EXPECT_EQ(parsed("a / b * c / d"), "(((a / b) * c) / d)");
    EXPECT_EQ(parsed("a && b && c"), "((a && b) && c)");
}

TEST(ScriptExpression, AssignmentsGoFromRightToLeft) {
    EXPECT_EQ(parsed("a = b = c"), "(a = (b = c))");
    EXPECT_EQ(parsed("a[1].b = c"), "(((a)[1]).b = c)");
}

TEST(ScriptExpression, WordsForOperators) {
    EXPECT_EQ(parsed("a and b or not c"), "(a && (b || (!c)))");
    EXPECT_EQ(parsed("x = a and b"), "(x = (a && b))");
}

TEST(ScriptExpression, ParenthesesGroup) {
    EXPECT_EQ(parsed("(a + b) * c"), "((a + b) * c)");
    EXPECT_EQ(parsed("((a))"), "a");
    EXPECT_EQ(parsed("(d6-res*5.0)[1]"), "((d6 - (res * 5.0)))[1]");
    EXPECT_EQ(parsed("(a).b"), "(a).b");
}

TEST(ScriptExpression, SignsStandInOneOrder) {
    EXPECT_EQ(parsed("+-!a"), "(+(-(!a)))");
    EXPECT_EQ(parsed("1 - -3"), "(1 - (-3))");
    EXPECT_EQ(parsed("!a.b()"), "(!a.b())");
    EXPECT_EQ(parsed("v[-1]"), "(v)[(-1)]");
}

TEST(ScriptExpression, NamesAndCalls) {
    EXPECT_EQ(parsed("a"), "a");
    EXPECT_EQ(parsed("a.b.c"), "a.b.c");
    EXPECT_EQ(parsed("a.b.c()"), "a.b.c()");
    EXPECT_EQ(parsed("f(1, \"b\", c)"), "f(1, \"b\", c)");
    EXPECT_EQ(parsed("KDL.Vector(1.0, g(2), array (3))"), "KDL.Vector(1.0, g(2), array(3))");
    EXPECT_EQ(parsed("f(x = 3)"), "f((x = 3))");
    EXPECT_EQ(parsed("ints[](1)"), "ints[](1)");
    EXPECT_EQ(parsed("std.vector<double>(1)"), "std.vector<double>(1)");
}

TEST(ScriptExpression, ColonsAreDots) {
    EXPECT_EQ(parsed("producer: configure()"), "producer.configure()");
    EXPECT_EQ(parsed("KDL::Vector(1.0)"), "KDL.Vector(1.0)");
}

TEST(ScriptExpression, MembersAndIndices) {
    EXPECT_EQ(parsed("a[1]"), "(a)[1]");
    EXPECT_EQ(parsed("a.b[i + 1][2].c.d"), "((((a.b)[(i + 1)])[2]).c).d");
    EXPECT_EQ(parsed("f().x"), "(f()).x");
    EXPECT_EQ(parsed("f()[0]"), "(f())[0]");
}

TEST(ScriptExpression, ReservedWordsCanBeMembers) {
    EXPECT_EQ(parsed("a.b.send(1)"), "a.b.send(1)");
    EXPECT_EQ(parsed("h.collectIfDone(x) == SendNotReady"), "(h.collectIfDone(x) == SendNotReady)");
    EXPECT_EQ(parsed("h.collect()"), "h.collect()");
    EXPECT_EQ(parsed("a.call()"), "a.call()");
    EXPECT_EQ(parsed("a[0].done"), "((a)[0]).done");
}

TEST(ScriptExpression, TheTimeCanBeANameAsWell) {
    EXPECT_EQ(parsed("time - t0"), "(time - t0)");
    EXPECT_EQ(parsed("time(1.0)"), "time(1.0)");
    EXPECT_EQ(parsed("time.now"), "time.now");
    EXPECT_EQ(parsed("a.time"), "a.time");
}

TEST(ScriptExpression, GoesOnOverLinesWhereAnOperatorFollows) {
    EXPECT_EQ(parsed("a\n + b\n * c"), "(a + (b * c))");
    EXPECT_EQ(parsed("a +\n\n b"), "(a + b)");
    EXPECT_EQ(parsed("a\n.b\n.c"), "a.b.c");
    EXPECT_EQ(parsed("a\n(1,\n2\n)"), "a(1, 2)");
    EXPECT_EQ(parsed("a\n[1]"), "(a)[1]");
    EXPECT_EQ(parsed("x\n=\n3"), "(x = 3)");
    EXPECT_EQ(parsed("a // one\n + # two\n /* three\n */ b"), "(a + b)");
}

TEST(ScriptExpression, EndsWithTheLineWhereNoneFollows) {
    EXPECT_EQ(parsed("a\nb"), "a ; b");
    EXPECT_EQ(parsed("a()\n(b)"), "a() ; b");
    EXPECT_EQ(parsed("a\n!b"), "a ; (!b)");
}

TEST(ScriptExpression, OldWordsBeforeItMeanNothing) {
    EXPECT_EQ(parsed("do a.b()"), "a.b()");
    EXPECT_EQ(parsed("set x[i] = v"), "((x)[i] = v)");
    EXPECT_EQ(parsed("call f(1)"), "f(1)");
    EXPECT_EQ(parsed("do set x = 1"), "(x = 1)");
}

}  // namespace
