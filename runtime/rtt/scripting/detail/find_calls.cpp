// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/find_calls.hpp>

#include <rtt/types/TypeInfoRepository.hpp>

#include <algorithm>

namespace RTT {
namespace scripting {
namespace detail {

namespace {

bool isType(const std::vector<ast::Identifier>& parts) {
    std::string name;
    for (const ast::Identifier& part : parts) name += (name.empty() ? "" : ".") + part.text;
    return types::TypeInfoRepository::Instance()->type(name) != nullptr;
}

struct Finder {
    bool in(const ast::ExpressionPtr& expression) const { return expression && std::visit(*this, expression->what); }
    bool in(const ast::StatementPtr& statement) const { return statement && std::visit(*this, statement->what); }
    bool in(const std::unique_ptr<ast::Block>& block) const { return block && in(*block); }
    bool in(const ast::Block& block) const { return any(block.statements); }
    template <class List>
    bool any(const List& list) const {
        return std::any_of(list.begin(), list.end(), [this](const auto& each) { return in(each); });
    }
    bool in(const ast::Binary::Step& step) const { return in(step.right); }
    bool in(const ast::Declarator& declarator) const { return in(declarator.size) || in(declarator.value); }

    bool operator()(const ast::Literal&) const { return false; }
    bool operator()(const ast::CurrentTime&) const { return false; }
    bool operator()(const ast::Name& name) const { return (name.called && !isType(name.parts)) || any(name.arguments); }
    bool operator()(const ast::Member& member) const { return in(member.of); }
    bool operator()(const ast::Index& index) const { return in(index.of) || in(index.index); }
    bool operator()(const ast::Unary& operation) const { return in(operation.operand); }
    bool operator()(const ast::Binary& row) const { return in(row.first) || any(row.steps); }
    bool operator()(const ast::Assignment& assignment) const { return in(assignment.to) || in(assignment.value); }

    bool operator()(const ast::Declaration& declaration) const { return any(declaration.names); }
    bool operator()(const ast::Do& statement) const {
        // `component.configure` is a call, too.
        return std::holds_alternative<ast::Name>(statement.expression->what) || in(statement.expression);
    }
    bool operator()(const ast::Nothing&) const { return false; }
    bool operator()(const ast::Yield&) const { return false; }
    bool operator()(const ast::Break&) const { return false; }
    bool operator()(const ast::Try&) const { return true; }
    bool operator()(const ast::Return& statement) const { return in(statement.value); }
    bool operator()(const ast::If& choice) const {
        return in(choice.condition) || in(choice.then) || in(choice.otherwise);
    }
    bool operator()(const ast::While& loop) const { return in(loop.condition) || in(loop.body); }
    bool operator()(const ast::For& loop) const {
        return in(loop.first) || in(loop.condition) || in(loop.next) || in(loop.body);
    }
};

}  // namespace

bool mayCall(const ast::Statement& statement) { return std::visit(Finder(), statement.what); }

}  // namespace detail
}  // namespace scripting
}  // namespace RTT
