// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/unit_compiler.hpp>

#include <rtt/scripting/detail/execute/instructions.hpp>
#include <rtt/scripting/detail/compile/overloaded.hpp>

namespace RTT::scripting::detail {

void StatementCompiler::compile(const std::vector<ast::StatementPtr>& statements) {
    for (const auto& each : statements) {
        try {
            compile(*each);
        } catch (const Unresolved&) {
            // Goes on, to report errors of later statements, too.
        }
    }
}

void StatementCompiler::compile(const ast::Statement& statement) {
    code_.beginStatement(statement.at);
    std::visit(
        Overloaded{[&](const ast::Declaration& s) { unit_.declarations.compile(s); },
                   [&](const ast::Do& s) { evaluate(*s.expression); },
                   // Old scripts use it to wait in loops: `while !done nothing`.
                   [&](const ast::Nothing&) { code_.add(&instructions::idle); },
                   [&](const ast::Yield&) { code_.add(&instructions::yield); }, [&](const ast::Try& s) { attempt(s); },
                   [&](const ast::Return& s) { giveBack(s); }, [&](const ast::If& s) { choose(s); },
                   [&](const ast::While& s) { loop(*s.condition, s.body, nullptr); },
                   [&](const ast::For& s) { repeat(s); }, [&](const ast::Break&) { breaks_.back().push_back(jump()); }},
        statement.what);
}

/** Evaluates an expression for its effects; an assignment is already complete. */
void StatementCompiler::evaluate(const ast::Expression& expression) {
    unit_.sends.ignore(expression);
    const Operand value = unit_.expressions.compile(expression);
    if (!std::holds_alternative<ast::Assignment>(expression.what)) values_.discard(value);
}

void StatementCompiler::end() { code_.add(&instructions::leave); }

void StatementCompiler::function(const ast::Function& tree, bool withBody) {
    try {
        unit_.declarations.functionHead(tree);
        if (withBody) compile(tree.body.statements);
        end();
    } catch (const Unresolved&) {
        // The error was reported.
    }
}

void StatementCompiler::attempt(const ast::Try& attempt) {
    const std::size_t from = code_.size();
    evaluate(*attempt.attempt);
    const std::size_t until = code_.size();
    if (until == from) return;
    const std::size_t over = jump();
    code_.guard(from, until, code_.size());
    if (attempt.handler) compile(attempt.handler->statements);
    land(over);
}

void StatementCompiler::giveBack(const ast::Return& statement) {
    if (statement.value && !(unit_.function && unit_.function->result))
        reporter_.error(statement.value->at, "OPS210",
                        unit_.function ? "function '" + unit_.function->name +
                                             "' returns nothing (void), but here it returns a value"
                                       : "found a value after 'return', which only functions give back");
    if (statement.value)
        values_.store(values_.fromSource(unit_.function->result, statement.value->at),
                      unit_.expressions.compile(*statement.value),
                      "the result of function '" + unit_.function->name + "'");
    end();
}

void StatementCompiler::choose(const ast::If& statement) {
    const std::size_t otherwise = jumpUnless(*statement.condition);
    compile(statement.then.statements);
    if (!statement.otherwise) return land(otherwise);
    const std::size_t over = jump();
    land(otherwise);
    compile(statement.otherwise->statements);
    land(over);
}

void StatementCompiler::repeat(const ast::For& statement) {
    const auto* const declaration = statement.first ? std::get_if<ast::Declaration>(&statement.first->what) : nullptr;
    const auto mark = [&](Scope::Entry::Loop loop) {
        for (const auto& declared : declaration->names) unit_.scope.markLoop(declared.name.text, loop);
    };
    // Consecutive loops may share a variable.
    if (declaration) {
        unit_.declarations.compile(*declaration, true);
        mark(Scope::Entry::Loop::Entered);
    } else if (statement.first && !std::holds_alternative<ast::Nothing>(statement.first->what)) {
        compile(*statement.first);
    }
    loop(*statement.condition, statement.body, statement.next.get());
    if (declaration) mark(Scope::Entry::Loop::Left);
}

void StatementCompiler::loop(const ast::Expression& condition, const ast::Block& body, const ast::Expression* next) {
    const std::size_t begin = code_.size();
    code_.beginStatement(condition.at);
    const std::size_t out = jumpUnless(condition);
    breaks_.emplace_back();
    compile(body.statements);
    if (next) {
        code_.beginStatement(next->at);
        evaluate(*next);
    }
    jumpBack(begin);
    land(out);
    for (const std::size_t jump : breaks_.back()) land(jump);
    breaks_.pop_back();
}

std::size_t StatementCompiler::jumpUnless(const ast::Expression& condition) {
    return code_.add(&instructions::jumpUnless, unit_.expressions.truth(condition).address);
}

std::size_t StatementCompiler::jump() { return code_.add(&instructions::jump); }

void StatementCompiler::land(std::size_t jump) {
    code_.at(jump).offset = static_cast<std::ptrdiff_t>(code_.size()) - static_cast<std::ptrdiff_t>(jump);
}

void StatementCompiler::jumpBack(std::size_t target) {
    const std::size_t from = code_.add(&instructions::jumpBack);
    code_.at(from).offset = static_cast<std::ptrdiff_t>(target) - static_cast<std::ptrdiff_t>(from);
}

}  // namespace RTT::scripting::detail
