// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ast_text.hpp"

#include <gtest/gtest.h>

namespace {

using tests::complaints;
using tests::parsed;

/// `items` in a state.
std::string inState(const std::string& items) {
    const std::string text = parsed("StateMachine T { state S { " + items + " } }");
    const std::string before = "StateMachine T { state S { ", after = "; }; }";
    const bool fits = text.compare(0, before.size(), before) == 0 && text.size() > before.size() + after.size();
    return fits ? text.substr(before.size(), text.size() - before.size() - after.size()) : text;
}

TEST(ScriptMachine, States) {
    EXPECT_EQ(parsed("StateMachine T { }"), "StateMachine T { }");
    EXPECT_EQ(parsed("StateMachine T\n{\n initial state A { }\n state B\n{ } final state C { } }"),
              "StateMachine T { initial state A { }; state B { }; final state C { }; }");
}

TEST(ScriptMachine, Declarations) {
    EXPECT_EQ(parsed("StateMachine T { var int a = 1; const int b = 2\n alias int c = a; param double d, e(2) }"),
              "StateMachine T { var int a = 1; const int b = 2; alias int c = a; param double d, e(2); }");
    EXPECT_EQ(parsed("StateMachine T { SubMachine U u\n SubMachine V v(p = 1, q = 2); state A { } var int a }"),
              "StateMachine T { var int a; SubMachine U u(); SubMachine V v(p = 1, q = 2); state A { }; }");
    EXPECT_EQ(inState("var int a; const int b = 1"), "var int a; const int b = 1");
}

TEST(ScriptMachine, Programs) {
    EXPECT_EQ(inState("entry { a } run { b; yield } handle { } exit { c }"),
              "entry { a }; run { b; yield }; handle {}; exit { c }");
    EXPECT_EQ(inState("entry\n{ run.start(); state = 1 }"), "entry { run.start(); (state = 1) }");
}

TEST(ScriptMachine, Preconditions) {
    EXPECT_EQ(inState("precondition a == 1; precondition b"), "precondition (a == 1); precondition b");
    EXPECT_EQ(inState("preconditions { a > 1\n b; if c then }"),
              "precondition (a > 1); precondition b; precondition c");
}

TEST(ScriptMachine, APreconditionMayHaveTheNextItemBehindIt) {
    EXPECT_EQ(inState("precondition a >= 0  entry { b }"), "entry { b }; precondition (a >= 0)");
    EXPECT_EQ(inState("precondition a precondition b transition select C"),
              "precondition a; precondition b; transition select C");
    EXPECT_EQ(complaints("StateMachine T { state S { precondition a b } }"),
              "test.ops:1:43: error: [OPS002] found 'b', expected a new line or ';' at the end of the statement\n"
              "StateMachine T { state S { precondition a b } }\n"
              "                                          ^\n");
}

TEST(ScriptMachine, PreconditionsThatSelectAnotherState) {
    EXPECT_EQ(inState("preconditions {\n if a then select F else { b } select G\n if c { d }; e\n select H or I\n}"),
              "precondition e; preconditions { if a then select F else { b } select G }; "
              "preconditions { if c then { d } }; preconditions { select H or I }");
    EXPECT_EQ(inState("precondition if a then select F"), "preconditions { if a then select F }");
}

TEST(ScriptMachine, PreconditionsThatSelectTheirOwnStateAreWarnedOf) {
    EXPECT_EQ(
        complaints("StateMachine T { state S { preconditions {\n if a then select S\n} } }"),
        "test.ops:2:12: warning: [OPS014] this changes nothing: state 'S' is entered anyway; 'precondition c' says "
        "that it is entered only if c is true\n"
        " if a then select S\n"
        "           ^\n");
    EXPECT_EQ(complaints("StateMachine T { state S { preconditions { if a then { b } select S } } }"), "");
}

TEST(ScriptMachine, TransitionsWithConditions) {
    EXPECT_EQ(inState("transition if a then select B"), "transition if a then select B");
    EXPECT_EQ(inState("transition if a select B"), "transition if a then select B");
    EXPECT_EQ(inState("transition select B"), "transition select B");
    EXPECT_EQ(inState("transitions { if a then select B\n if c then select D }"),
              "transition if a then select B; transition if c then select D");
    EXPECT_EQ(inState("transitions { } transition select C or D or E"), "transition select C or D or E");
}

TEST(ScriptMachine, TransitionsWithElse) {
    EXPECT_EQ(inState("transition if a then select B else select C"), "transition if a then select B else select C");
    EXPECT_EQ(inState("transitions { if a then select B;\n else select C; if d then select E }"),
              "transition if a then select B else select C; transition if d then select E");
}

TEST(ScriptMachine, TransitionsWithPrograms) {
    EXPECT_EQ(inState("transition { x = 1 } select B"), "transition { (x = 1) } select B");
    EXPECT_EQ(inState("transition if a then { x } else { y } select C"),
              "transition if a then { x } else { y } select C");
    EXPECT_EQ(inState("transitions { if a then { x }\n if b then { y } }"),
              "transition if a then { x }; transition if b then { y }");
}

TEST(ScriptMachine, Events) {
    EXPECT_EQ(inState("transition ev() select B"), "transition ev() select B");
    EXPECT_EQ(inState("transition peer.service.ev(a, b) if a > 1 then { x } select B else select C"),
              "transition peer.service.ev(a, b) if (a > 1) then { x } select B else select C");
    EXPECT_EQ(inState("transitions { port(x) select A\n peer: ev(y) { z } \n select(a) select B }"),
              "transition port(x) select A; transition peer.ev(y) { z }; transition select(a) select B");
}

TEST(ScriptMachine, TransitionsOfTheWholeMachine) {
    EXPECT_EQ(
        parsed("StateMachine T { var int a\n transition if a == 1 then select E\n transitions { ev(a) select F }\n"
               " state E { } }"),
        "StateMachine T { var int a; transition if (a == 1) then select E; transition ev(a) select F; state E { }; }");
}

TEST(ScriptMachine, BreaksOfLoopsInPrograms) {
    EXPECT_EQ(inState("run { while true { break } }"), "run { while true { break } }");
    EXPECT_EQ(complaints("program p { while true {\n yield } }\nStateMachine T { state S { run {\n break\n} } }"),
              "test.ops:4:2: error: [OPS011] found 'break' outside of 'for' and 'while'\n"
              " break\n"
              " ^\n");
}

}  // namespace
