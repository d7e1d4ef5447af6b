// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/find_calls.hpp>

#include <rtt/types/TypeInfoRepository.hpp>

#include <set>
#include <string>

namespace RTT::scripting::detail {

namespace {

bool isType(const std::vector<ast::Identifier>& parts) {
    std::string name;
    for (const ast::Identifier& part : parts) name += (name.empty() ? "" : ".") + part.text;
    return types::TypeInfoRepository::Instance()->type(name) != nullptr;
}

/** Relies on both sides of `&&` and `||` being executed, so that their calls are certain. */
class Finder {
public:
    explicit Finder(bool certain) : certain_(certain) {}

    void in(const ast::ExpressionPtr& expression) {
        if (!expression) return;
        at_ = expression->at;
        current_ = expression.get();
        std::visit(*this, expression->what);
    }
    void in(const ast::StatementPtr& statement) {
        if (statement) std::visit(*this, statement->what);
    }
    void in(const ast::Block& block) {
        for (const ast::StatementPtr& each : block.statements) in(each);
    }
    void in(const std::unique_ptr<ast::Block>& block) {
        if (block) in(*block);
    }
    void in(const ast::Statement& statement) { std::visit(*this, statement.what); }

    void operator()(const ast::Literal&) {}
    void operator()(const ast::CurrentTime&) {}
    void operator()(const ast::Name& name) {
        const FoundCall call{&name, at_, certain_, ignored_.count(current_) != 0};
        for (const ast::ExpressionPtr& each : name.arguments) in(each);
        if (!name.called || !isType(name.parts)) calls.push_back(call);
    }
    void operator()(const ast::Member& member) { in(member.of); }
    void operator()(const ast::Index& index) {
        in(index.of);
        in(index.index);
    }
    void operator()(const ast::Unary& operation) { in(operation.operand); }
    void operator()(const ast::Binary& row) {
        in(row.first);
        for (const ast::Binary::Step& step : row.steps) in(step.right);
    }
    void operator()(const ast::Assignment& assignment) {
        in(assignment.value);
        // The target of an assignment is not a call, but its index may have one.
        if (!std::holds_alternative<ast::Name>(assignment.to->what)) in(assignment.to);
    }

    void operator()(const ast::Declaration& declaration) {
        for (const ast::Declarator& each : declaration.names) {
            in(each.size);
            in(each.value);
        }
    }
    void operator()(const ast::Do& statement) {
        forIgnored(*statement.expression, [this](const ast::Expression& each) { ignored_.insert(&each); });
        in(statement.expression);
    }
    void operator()(const ast::Nothing&) {}
    void operator()(const ast::Yield&) {}
    void operator()(const ast::Break&) {}
    /** Calls in a `try` are expected to fail. */
    void operator()(const ast::Try& attempt) {
        in(attempt.attempt);
        perhaps([&] { in(attempt.handler); });
    }
    void operator()(const ast::Return& statement) { in(statement.value); }
    void operator()(const ast::If& choice) {
        in(choice.condition);
        perhaps([&] {
            in(choice.then);
            in(choice.otherwise);
        });
    }
    void operator()(const ast::While& loop) {
        in(loop.condition);
        perhaps([&] { in(loop.body); });
    }
    void operator()(const ast::For& loop) {
        in(loop.first);
        in(loop.condition);
        perhaps([&] {
            in(loop.body);
            in(loop.next);
        });
    }

    std::vector<FoundCall> calls;

private:
    template <class Search>
    void perhaps(Search search) {
        const bool before = certain_;
        certain_ = false;
        search();
        certain_ = before;
    }

    bool certain_;
    ast::Place at_;
    const ast::Expression* current_ = nullptr;
    std::set<const ast::Expression*> ignored_;
};

template <class Tree>
std::vector<FoundCall> found(const Tree& tree, bool certain) {
    Finder finder(certain);
    finder.in(tree);
    return std::move(finder.calls);
}

}  // namespace

std::vector<FoundCall> callsIn(const ast::Statement& statement) { return found(statement, true); }
std::vector<FoundCall> callsIn(const ast::Block& block) { return found(block, false); }

}  // namespace RTT::scripting::detail
