// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ast_text.hpp"

#include <gtest/gtest.h>

namespace {

using tests::parsed;

TEST(ScriptStatement, NothingIsAScript) {
    EXPECT_EQ(parsed(""), "");
    EXPECT_EQ(parsed("\n ; \n;;"), "");
    EXPECT_EQ(parsed("# only a comment"), "");
}

TEST(ScriptStatement, EndsAtNewlineSemicolonOrBrace) {
    EXPECT_EQ(parsed("a; b\nc ;d;\ne"), "a ; b ; c ; d ; e");
    EXPECT_EQ(parsed("if a then { b } c"), "if a then { b } ; c");
    EXPECT_EQ(parsed("a // one\nb # two\nc /* three */\nd"), "a ; b ; c ; d");
    EXPECT_EQ(parsed("a\r\nb\r\n"), "a ; b");
}

TEST(ScriptStatement, Variables) {
    EXPECT_EQ(parsed("var int x"), "var int x");
    EXPECT_EQ(parsed("var int x = 1 + 2, y, z = 3"), "var int x = (1 + 2), y, z = 3");
    EXPECT_EQ(parsed("var strings s(3), t(n) = u"), "var strings s(3), t(n) = u");
    EXPECT_EQ(parsed("var /std_msgs/Float64[] m"), "var /std_msgs/Float64[] m");
    EXPECT_EQ(parsed("var KDL.Frame f; var std::vector<double> d"), "var KDL.Frame f ; var std::vector<double> d");
    EXPECT_EQ(parsed("var int\nx\n= 3"), "var int x = 3");
}

TEST(ScriptStatement, ConstantsAndAliases) {
    EXPECT_EQ(parsed("const int x = 1, y = 2"), "const int x = 1, y = 2");
    EXPECT_EQ(parsed("alias double a = b.c[1]"), "alias double a = (b.c)[1]");
}

TEST(ScriptStatement, KeywordsOfOtherPlacesAreNames) {
    EXPECT_EQ(parsed("var int state, entry, run, program, select, time, break, param"),
              "var int state, entry, run, program, select, time, break, param");
    EXPECT_EQ(parsed("program = 1; run.start(); break = 2; function; export.x; select(1)"),
              "(program = 1) ; run.start() ; (break = 2) ; function ; export.x ; select(1)");
}

TEST(ScriptStatement, YieldAndNothing) {
    EXPECT_EQ(parsed("yield; do yield; nothing; do nothing"), "yield ; yield ; nothing ; nothing");
}

TEST(ScriptStatement, If) {
    EXPECT_EQ(parsed("if a then b"), "if a then { b }");
    EXPECT_EQ(parsed("if (a == 1) then { b; c\nd }"), "if (a == 1) then { b; c; d }");
    EXPECT_EQ(parsed("if a\nthen\nb\nelse\nc"), "if a then { b } else { c }");
    EXPECT_EQ(parsed("if a then {} else { c }"), "if a then {} else { c }");
    EXPECT_EQ(parsed("if !f(x) then return \"\""), "if (!f(x)) then { return \"\" }");
}

TEST(ScriptStatement, ElseCanStandBehindASemicolon) {
    EXPECT_EQ(parsed("if a then b; else c"), "if a then { b } else { c }");
    EXPECT_EQ(parsed("if a then b;\nelse c; d"), "if a then { b } else { c } ; d");
    EXPECT_EQ(parsed("if a then { b } ; else c"), "if a then { b } else { c }");
}

TEST(ScriptStatement, ElseBelongsToTheInnermostIf) {
    EXPECT_EQ(parsed("if a then if b then c else d"), "if a then { if b then { c } else { d } }");
    EXPECT_EQ(parsed("if a then b else if c then d else e"), "if a then { b } else { if c then { d } else { e } }");
}

TEST(ScriptStatement, While) {
    EXPECT_EQ(parsed("while (h.collectIfDone(x) == SendNotReady) yield"),
              "while (h.collectIfDone(x) == SendNotReady) { yield }");
    EXPECT_EQ(parsed("while a { b; break }"), "while a { b; break }");
    EXPECT_EQ(parsed("while (a) x = 3"), "while a { (x = 3) }");
    EXPECT_EQ(parsed("while a if b then break; else c"), "while a { if b then { break } else { c } }");
}

TEST(ScriptStatement, For) {
    EXPECT_EQ(parsed("for(var int i = 0 ; i < list.size ; i = i + 1) { print.ln(i) }"),
              "for (var int i = 0; (i < list.size); (i = (i + 1))) { print.ln(i) }");
    EXPECT_EQ(parsed("for (set i = 0; i < 3; set i = i + 1) a"), "for ((i = 0); (i < 3); (i = (i + 1))) { a }");
    EXPECT_EQ(parsed("for (nothing; a; b())\nc"), "for (nothing; a; b()) { c }");
}

TEST(ScriptStatement, TryAndCatch) {
    EXPECT_EQ(parsed("try a.b()"), "try a.b()");
    EXPECT_EQ(parsed("try set x = 1"), "try (x = 1)");
    EXPECT_EQ(parsed("try a catch { b }"), "try a catch { b }");
    EXPECT_EQ(parsed("try a;\ncatch b\nc"), "try a catch { b } ; c");
}

TEST(ScriptStatement, ReturnTakesAValueOnItsLine) {
    EXPECT_EQ(parsed("return a +\nb"), "return (a + b)");
    EXPECT_EQ(parsed("return\na"), "return ; a");
    EXPECT_EQ(parsed("return; a"), "return ; a");
    EXPECT_EQ(parsed("if a then return else return b"), "if a then { return } else { return b }");
    EXPECT_EQ(parsed("if a then { return }"), "if a then { return }");
}

}  // namespace
