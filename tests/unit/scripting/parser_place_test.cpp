// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ast_text.hpp"

#include <rtt/scripting/detail/syntax/parser.hpp>

#include <gtest/gtest.h>

namespace {

using namespace RTT::scripting::detail;  // NOLINT: the tree is the subject

struct ScriptPlace : ::testing::Test {
    std::string text;
    ast::Script script;

    void read(const std::string& script_text) {
        text = script_text;
        oroforge::diag::Sink sink;
        script = parse(text, "test.ops", sink);
        ASSERT_TRUE(sink.empty()) << tests::complaints(text);
    }
    template <class What>
    const What& item(std::size_t i) const {
        return std::get<What>(script.items.at(i).what);
    }
    const ast::Statement& statement(std::size_t i) const { return *item<ast::StatementPtr>(i); }
    const ast::Expression& expression(std::size_t i) const { return *std::get<ast::Do>(statement(i).what).expression; }
    std::string itemText(std::size_t i) const { return text.substr(script.items.at(i).begin, script.items.at(i).size); }
};

std::string at(ast::Place place) { return std::to_string(place.line) + ":" + std::to_string(place.column); }

TEST_F(ScriptPlace, ItemsKnowTheirLetters) {
    read("a ; // b\n  program p {\n  c\n} # d\nf(\n 1 )");
    EXPECT_EQ(itemText(0), "a");
    EXPECT_EQ(at(script.items[0].at), "1:1");
    EXPECT_EQ(at(script.items[0].end), "1:1");
    EXPECT_EQ(itemText(1), "program p {\n  c\n}");
    EXPECT_EQ(at(script.items[1].at), "2:3");
    EXPECT_EQ(at(script.items[1].end), "4:1");
    EXPECT_EQ(itemText(2), "f(\n 1 )");
    EXPECT_EQ(at(script.items[2].end), "6:4");
}

TEST_F(ScriptPlace, TypesAtTheEndOfAnItemAreCounted) {
    read("var int abc\nx");
    EXPECT_EQ(itemText(0), "var int abc");
    EXPECT_EQ(at(script.items[0].end), "1:11");
}

TEST_F(ScriptPlace, ColumnsCountBytes) {
    read("x = \"\xC3\xA9\" + y");
    const auto& sum = *std::get<ast::Assignment>(expression(0).what).value;
    EXPECT_EQ(at(sum.at), "1:10");
}

TEST_F(ScriptPlace, OperationsAreAtTheirOperator) {
    read("ab = cd + -(ef * g)");
    EXPECT_EQ(at(expression(0).at), "1:4");
    const auto& sum = *std::get<ast::Assignment>(expression(0).what).value;
    EXPECT_EQ(at(sum.at), "1:9");
    const auto& step = std::get<ast::Binary>(sum.what).steps[0];
    EXPECT_EQ(at(step.at), "1:9");
    const ast::Expression& minus = *step.right;
    EXPECT_EQ(at(minus.at), "1:11");
    EXPECT_EQ(at(std::get<ast::Unary>(minus.what).operand->at), "1:16");
}

TEST_F(ScriptPlace, OthersAreAtTheirFirstLetter) {
    read(" (a + b)[1]\n f(x).y.z");
    EXPECT_EQ(at(expression(0).at), "1:2");
    EXPECT_EQ(at(expression(1).at), "2:2");
    const auto& member = std::get<ast::Member>(expression(1).what);
    EXPECT_EQ(at(member.member.at), "2:9");
    EXPECT_EQ(at(member.of->at), "2:2");
    const auto& call = *std::get<ast::Member>(member.of->what).of;
    EXPECT_EQ(at(std::get<ast::Name>(call.what).arguments[0]->at), "2:4");
}

TEST_F(ScriptPlace, PartsOfNames) {
    read("a. bc\n.d()");
    const auto& name = std::get<ast::Name>(expression(0).what);
    EXPECT_EQ(at(name.parts[1].at), "1:4");
    EXPECT_EQ(at(name.parts[2].at), "2:2");
}

TEST_F(ScriptPlace, Declarations) {
    read("var /a/B  x,\n y(2) = 3");
    const auto& declaration = std::get<ast::Declaration>(statement(0).what);
    EXPECT_EQ(at(statement(0).at), "1:1");
    EXPECT_EQ(at(declaration.type.at), "1:5");
    EXPECT_EQ(at(declaration.names[0].name.at), "1:11");
    EXPECT_EQ(at(declaration.names[1].name.at), "2:2");
    EXPECT_EQ(at(declaration.names[1].size->at), "2:4");
}

TEST_F(ScriptPlace, BlocksAreAtTheirBracesOrStatement) {
    read("if a then {\n b\n } else c.d()");
    const auto& branch = std::get<ast::If>(statement(0).what);
    EXPECT_EQ(at(branch.then.at), "1:11");
    EXPECT_EQ(at(branch.then.end), "3:2");
    EXPECT_EQ(at(branch.then.statements[0]->at), "2:2");
    EXPECT_EQ(at(branch.otherwise->at), "3:9");
    EXPECT_EQ(at(branch.otherwise->end), "3:9");
}

TEST_F(ScriptPlace, PrefixesBelongToTheStatement) {
    read("do set x = 1\ntry y catch z");
    EXPECT_EQ(at(statement(0).at), "1:1");
    EXPECT_EQ(at(statement(1).at), "2:1");
}

TEST_F(ScriptPlace, Functions) {
    read("export double f(int a) { }\nfunction g { }");
    const auto& f = item<ast::Function>(0);
    EXPECT_EQ(at(f.type.at), "1:8");
    EXPECT_EQ(at(f.name.at), "1:15");
    EXPECT_EQ(at(f.arguments[0].type.at), "1:17");
    EXPECT_EQ(at(f.arguments[0].name.at), "1:21");
    EXPECT_EQ(at(f.body.end), "1:26");
    EXPECT_EQ(at(item<ast::Function>(1).type.at), "2:1");
}

TEST_F(ScriptPlace, StateMachines) {
    read(
        "StateMachine T {\n initial state A {\n  transition ev(x) if y then select B or C else { z }\n }\n}\n"
        "RootMachine T m(p = 1)");
    const auto& machine = item<ast::StateMachine>(0);
    EXPECT_EQ(at(machine.type.at), "1:14");
    EXPECT_EQ(at(machine.end), "5:1");
    const ast::State& state = machine.states.at(0);
    EXPECT_EQ(at(state.name.at), "2:16");
    EXPECT_EQ(at(state.end), "4:2");
    const ast::Transition& transition = state.transitions.at(0);
    EXPECT_EQ(at(transition.at), "3:14");
    EXPECT_EQ(at(transition.event.at(0).at), "3:14");
    EXPECT_EQ(at(transition.selection.at), "3:30");
    EXPECT_EQ(at(transition.selection.states.at(1).at), "3:42");
    EXPECT_EQ(at(transition.otherwise->at), "3:49");
    const auto& root = item<ast::Instance>(1);
    EXPECT_EQ(at(root.at), "6:1");
    EXPECT_EQ(at(root.type.at), "6:13");
    EXPECT_EQ(at(root.name.at), "6:15");
    EXPECT_EQ(at(root.arguments.at(0).name.at), "6:17");
}

}  // namespace
