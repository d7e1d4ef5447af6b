// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/unit_compiler.hpp>

#include <rtt/scripting/detail/compile/find_calls.hpp>
#include <rtt/scripting/detail/execute/instructions.hpp>
#include <rtt/scripting/detail/compile/overloaded.hpp>

namespace RTT::scripting::detail {

void UnitCompiler::block(const ast::Block& block) {
    for (const auto& each : block.statements) {
        try {
            statement(*each);
        } catch (const Unresolved&) {
            // Goes on, to report errors of later statements, too.
        }
    }
}

void UnitCompiler::statement(const ast::Statement& statement) {
    code_.beginStatement(statement.at);
    std::visit(
        Overloaded{[&](const ast::Declaration& s) { declare(s); }, [&](const ast::Do& s) { evaluate(*s.expression); },
                   // Old scripts use it to wait in loops: `while !done nothing`.
                   [&](const ast::Nothing&) { emit(&instructions::idle); },
                   [&](const ast::Yield&) { emit(&instructions::yield); }, [&](const ast::Try& s) { attempt(s); },
                   [&](const ast::Return& s) { giveBack(s); }, [&](const ast::If& s) { choose(s); },
                   [&](const ast::While& s) { repeat(s); }, [&](const ast::For& s) { repeat(s); },
                   [&](const ast::Break&) { breaks_.back().push_back(jump()); }},
        statement.what);
}

/** Evaluates an expression for its effects; an assignment is already complete. */
void UnitCompiler::evaluate(const ast::Expression& expression) {
    ignored_.clear();
    forIgnored(expression, [this](const ast::Expression& each) {
        if (const auto* const name = std::get_if<ast::Name>(&each.what)) ignored_.insert(name);
    });
    const Operand value = this->expression(expression);
    if (!std::holds_alternative<ast::Assignment>(expression.what)) discard(value);
}

void UnitCompiler::end() { emit(&instructions::leave); }

void UnitCompiler::attempt(const ast::Try& attempt) {
    const std::size_t from = code_.size();
    evaluate(*attempt.attempt);
    const std::size_t until = code_.size();
    if (until == from) return;
    const std::size_t over = jump();
    code_.guard(from, until, code_.size());
    if (attempt.handler) block(*attempt.handler);
    land(over);
}

void UnitCompiler::giveBack(const ast::Return& statement) {
    if (statement.value && !(function_ && function_->result))
        error(statement.value->at, "OPS210",
              function_ ? "function '" + function_->name + "' returns nothing (void), but here it returns a value"
                        : "found a value after 'return', which only functions give back");
    if (statement.value)
        store(fromSource(function_->result, statement.value->at), expression(*statement.value),
              "the result of function '" + function_->name + "'");
    end();
}

void UnitCompiler::choose(const ast::If& statement) {
    const std::size_t otherwise = jumpUnless(truth(*statement.condition));
    block(statement.then);
    if (!statement.otherwise) return land(otherwise);
    const std::size_t over = jump();
    land(otherwise);
    block(*statement.otherwise);
    land(over);
}

void UnitCompiler::repeat(const ast::While& statement) { loop(statement.condition.get(), statement.body, nullptr); }

void UnitCompiler::repeat(const ast::For& statement) {
    const auto* const declaration = statement.first ? std::get_if<ast::Declaration>(&statement.first->what) : nullptr;
    const auto mark = [&](Scope::Entry::Loop loop) {
        for (const auto& declared : declaration->names) scope_->markLoop(declared.name.text, loop);
    };
    // Consecutive loops may share a variable.
    if (declaration) {
        declare(*declaration, true);
        mark(Scope::Entry::Loop::Entered);
    } else if (statement.first && !std::holds_alternative<ast::Nothing>(statement.first->what)) {
        this->statement(*statement.first);
    }
    loop(statement.condition.get(), statement.body, statement.next.get());
    if (declaration) mark(Scope::Entry::Loop::Left);
}

void UnitCompiler::loop(const ast::Expression* condition, const ast::Block& body, const ast::Expression* next) {
    const std::size_t begin = code_.size();
    code_.beginStatement(condition->at);
    const std::size_t out = jumpUnless(truth(*condition));
    breaks_.emplace_back();
    block(body);
    if (next) {
        code_.beginStatement(next->at);
        evaluate(*next);
    }
    jumpBack(begin);
    land(out);
    for (const std::size_t jump : breaks_.back()) land(jump);
    breaks_.pop_back();
}

std::size_t UnitCompiler::jumpUnless(const Operand& condition) {
    return emit(&instructions::jumpUnless, condition.address);
}

std::size_t UnitCompiler::jump() { return emit(&instructions::jump); }

void UnitCompiler::land(std::size_t jump) {
    code_.at(jump).offset = static_cast<std::ptrdiff_t>(code_.size()) - static_cast<std::ptrdiff_t>(jump);
}

void UnitCompiler::jumpBack(std::size_t target) {
    const std::size_t from = emit(&instructions::jumpBack);
    code_.at(from).offset = static_cast<std::ptrdiff_t>(target) - static_cast<std::ptrdiff_t>(from);
}

}  // namespace RTT::scripting::detail
