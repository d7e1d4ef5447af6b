// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Control flow.
#include "script_fixture.hpp"

using namespace RTT;
using namespace RTT::scripting::detail;

namespace {
class Statements : public ScriptTest {};
}  // namespace

TEST_F(Statements, IfAndElse) {
    ASSERT_TRUE(
        run("var int x\nif 1 < 2 then x = 1\nif x == 2 then { x = 5 } else { x = x + 10 }\n"
            "if (x == 11 && true) then\n  x = x * 2\nelse\n  x = 0"))
        << messages();
    EXPECT_EQ(value<int>("x"), 22);
}

TEST_F(Statements, ConditionsAreConvertedToTruth) {
    ASSERT_TRUE(run("var int x\nif 3 then x = 1\nif NewData then x = x + 1\nif NoData then x = 100")) << messages();
    EXPECT_EQ(value<int>("x"), 2);
    EXPECT_FALSE(run("if \"text\" then x = 3"));
    EXPECT_EQ(messages(),
              "script.ops:1:4: error: [OPS121] expected a condition, which is true or false, found a value "
              "of type string\n");
}

TEST_F(Statements, Loops) {
    ASSERT_TRUE(
        run("var int sum\nfor (var int i = 0; i < 5; i = i + 1) sum = sum + i\n"
            "for (var int i = 0; i < 5; i = i + 1) { if i == 3 then break\n sum = sum + 100 }\n"
            "var int n = 3\nwhile (n > 0) { sum = sum + 1000; n = n - 1 }\nfor (n = 7; n > 5; set n = n - 1) nothing"))
        << messages();
    EXPECT_EQ(value<int>("sum"), 3310);
    EXPECT_EQ(value<int>("n"), 5);
}

TEST_F(Statements, ALoopWithinALoopHasAVariableOfItsOwn) {
    EXPECT_FALSE(run("for (var int i = 0; i < 3; i = i + 1) { for (var int i = 0; i < 2; i = i + 1) nothing }"));
    EXPECT_EQ(messages(), "script.ops:1:54: error: [OPS111] 'i' is already declared in the script\n");
    EXPECT_FALSE(run("var int k = 42\nfor (var int k = 0; k < 3; k = k + 1) nothing"));
    EXPECT_EQ(messages(), "script.ops:2:14: error: [OPS111] 'k' is already declared in the script\n");
}

TEST_F(Statements, PausingWaitsForTheEndOfAStatement) {
    ast::Script tree = parse("program p {\n  halt()\n  one() + one() + one()\n  one()\n}", "f.ops", sink);
    Process* running = nullptr;
    int calls = 0;
    component.addOperation("halt", [&running] { running->pause(); });
    component.addOperation("one", [&] {
        running->pause();
        return ++calls;
    });
    Compiler compiler(context());
    const auto code = compiler.program(std::get<ast::Program>(tree.items[0].what).body, "program 'p'", scope);
    ASSERT_TRUE(code) << messages();
    Process process(*code);
    running = &process;
    EXPECT_EQ(process.run(), Outcome::Paused);
    EXPECT_EQ(process.line(), 3u);
    EXPECT_EQ(process.run(), Outcome::Paused);
    EXPECT_EQ(process.line(), 4u);
    EXPECT_EQ(calls, 3);
}

TEST_F(Statements, AFailedStatementIsRetriedFromItsBeginning) {
    ast::Script tree = parse("program p {\n  x = (y + 1) / z\n}", "f.ops", sink);
    int x = 0, y = 1, z = 0;
    component.addAttribute("x", x);
    component.addAttribute("y", y);
    component.addAttribute("z", z);
    Compiler compiler(context());
    const auto code = compiler.program(std::get<ast::Program>(tree.items[0].what).body, "program 'p'", scope);
    ASSERT_TRUE(code) << messages();
    Process process(*code);
    EXPECT_EQ(process.run(), Outcome::Failed);
    y = 9;
    z = 2;
    process.retry();
    EXPECT_EQ(process.run(), Outcome::Finished);
    EXPECT_EQ(x, 5);
}

TEST_F(Statements, BreakLeavesTheInnermostLoop) {
    ASSERT_TRUE(run("var int x\nwhile (true) {\n  while (true) { break }\n  x = x + 1\n  if x == 3 then { break }\n}"))
        << messages();
    EXPECT_EQ(value<int>("x"), 3);
}

TEST_F(Statements, YieldGoesOnInTheNextStep) {
    ASSERT_TRUE(run("program p { var int i\n while (i < 4) { i = i + 1; yield } }")) << messages();
    EXPECT_EQ(yields, 4);
}

TEST_F(Statements, AllErrorsOfAProgramAreReported) {
    EXPECT_FALSE(run("program p {\n  var sting a\n  var int b = \"x\"\n  b = unknown\n  nothing\n}"));
    EXPECT_EQ(sink.errorCount(), 3u);
    EXPECT_EQ(sink.all()[2].where.line, 4u);
}

TEST_F(Statements, AStepIsOneStatement) {
    ast::Script tree = parse("program p {\n  var int a = 1\n  if a == 1 then\n    a = 2\n  a = 3\n}", "f.ops", sink);
    Compiler compiler(context());
    const auto code = compiler.program(std::get<ast::Program>(tree.items[0].what).body, "program 'p'", scope);
    ASSERT_TRUE(code) << messages();
    Process process(*code);
    std::vector<unsigned> lines;
    while (process.runStatement() == Outcome::Yielded) lines.push_back(process.line());
    EXPECT_EQ(lines, (std::vector<unsigned>{3, 4, 5}));
    EXPECT_FALSE(process.started());
}

TEST_F(Statements, LoopsWithoutYieldCanBeLimited) {
    ast::Script tree = parse("program p {\n  var int i\n  while (true)\n    i = i + 1\n}", "f.ops", sink);
    Compiler compiler(context());
    const auto code = compiler.program(std::get<ast::Program>(tree.items[0].what).body, "program 'p'", scope);
    ASSERT_TRUE(code) << messages();
    Process process(*code);
    process.setRoundLimit(100);
    EXPECT_EQ(process.run(), Outcome::Failed);
    EXPECT_EQ(process.message(),
              "the loop went round 100 times in one step of the component, which is the limit; add a 'yield' to it");
    EXPECT_EQ(process.line(), 4u);
    EXPECT_EQ(process.run(), Outcome::Failed);
    process.restart();
    EXPECT_EQ(process.run(), Outcome::Failed);
}
