// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/unit_compiler.hpp>

#include <exception>
#include <string>
#include <utility>

namespace RTT::scripting::detail {

namespace {

/** Makes a Code that `fill` fills; null if there was an error. `at`: for unexpected errors. */
template <class Fill>
std::unique_ptr<Code> codeOf(Compiler::State& state, Scope& scope, Fill fill, ast::Place at = {0, 0}) {
    const CompileContext& where = state.where;
    const std::size_t errors = where.sink->errorCount();
    auto code = std::make_unique<Code>();
    code->keep(state.activations);
    UnitCompiler unit(state, where, *code, scope);
    try {
        fill(unit);
        unit.statements.end();
    } catch (const Unresolved&) {
        return nullptr;  // reported, unless the name may exist later
    } catch (const std::exception& thrown) {
        where.sink->error({where.file, at.line, at.column}, "OPS119",
                          std::string("cannot be compiled: ") + thrown.what());
    }
    if (where.sink->errorCount() != errors) return nullptr;
    return code;
}

}  // namespace

Compiler::Compiler(CompileContext context) : state_(new State(std::move(context))) {}

Compiler::~Compiler() = default;

std::unique_ptr<Code> Compiler::program(const ast::Block& block, const std::string& name, const Scope& scope) {
    Scope own(name, &scope);
    return codeOf(*state_, own, [&](UnitCompiler& unit) { unit.statements.compile(block.statements); });
}

std::unique_ptr<Code> Compiler::statement(const ast::Statement& statement, Scope& scope) {
    return codeOf(*state_, scope, [&](UnitCompiler& unit) { unit.statements.compile(statement); });
}

std::unique_ptr<Code> Compiler::declarations(const std::vector<ast::StatementPtr>& declarations, Scope& scope) {
    return codeOf(*state_, scope, [&](UnitCompiler& unit) { unit.statements.compile(declarations); });
}

std::unique_ptr<Code> Compiler::assignment(base::DataSourceBase::shared_ptr to, const ast::Expression& value,
                                           const std::string& what, const Scope& scope) {
    Scope own("", &scope);
    return codeOf(*state_, own, [&](UnitCompiler& unit) {
        unit.code.beginStatement(value.at);
        unit.values.store(unit.values.fromSource(to, value.at), unit.expressions.compile(value), what);
    });
}

std::unique_ptr<Code> Compiler::value(const ast::Expression& expression, Scope& scope,
                                      base::DataSourceBase::shared_ptr& result) {
    const auto fill = [&](UnitCompiler& unit) {
        unit.code.beginStatement(expression.at);
        const Operand value = unit.expressions.compile(expression);
        if (value.kind == Kind::None) return unit.values.discard(value);
        const base::DataSourceBase::shared_ptr source = unit.values.sourceOf(value);
        result = source->getTypeInfo()->buildValue();
        if (result) return unit.values.store(unit.values.fromSource(result, value.at), value, "its copy");
        unit.values.discard(value);
        result = source;
    };
    return codeOf(*state_, scope, fill, expression.at);
}

std::unique_ptr<Code> Compiler::condition(const ast::Expression& expression, const Scope& scope, const bool*& result) {
    Scope own("", &scope);
    return codeOf(*state_, own, [&](UnitCompiler& unit) {
        unit.code.beginStatement(expression.at);
        result = static_cast<const bool*>(unit.expressions.truth(expression).address);
    });
}

base::DataSourceBase::shared_ptr Compiler::variable(const ast::Expression& expression, const Scope& scope) {
    base::DataSourceBase::shared_ptr found;
    Scope own("", &scope);
    const auto code = codeOf(*state_, own, [&](UnitCompiler& unit) {
        const Operand operand = unit.expressions.compile(expression);
        if (operand.assignable()) found = operand.source;
    });
    // Code that must be executed first, for example to compute an index, would be lost.
    return code && code->size() == 1 ? found : nullptr;
}

std::unique_ptr<Activation> Compiler::function(const FunctionDefinition& definition) {
    try {
        state_->activateCalls(definition);
    } catch (const Unresolved&) {
        // Reported below.
    }
    auto made = state_->compile(definition);
    if (made) made->code.keep(state_->activations);
    return made;
}

std::unique_ptr<Activation> Compiler::check(const FunctionDefinition& definition) {
    state_->callsOnly = state_->where.checkOnly = true;
    auto made = state_->compile(definition);
    definition.calls = std::move(state_->calls);
    definition.size = 1;
    for (const auto& called : definition.calls) definition.size += called->size;
    return made;
}

std::unique_ptr<Activation> Compiler::State::compile(const FunctionDefinition& definition) {
    const ast::Function& tree = *definition.tree;
    CompileContext there = where;
    there.file = definition.file;
    there.text = definition.text;
    if (definition.functions) {
        there.known = where.functions;
        there.functions = definition.functions.get();
    }
    const std::size_t errors = where.sink->errorCount();
    auto activation = std::make_unique<Activation>();
    activation->name = definition.name;
    activation->file = definition.file;
    activation->text = definition.text;
    Scope scope("function '" + definition.name + "'", definition.scope.get(), definition.defined);
    UnitCompiler unit(*this, there, activation->code, scope, activation.get());
    unit.statements.function(tree, !(callsOnly && quiet != 0));
    if (where.sink->errorCount() != errors) return nullptr;
    return activation;
}

void Compiler::State::activateCalls(const FunctionDefinition& definition) {
    struct Step {
        const FunctionDefinition* of;
        std::size_t next;
    };
    std::vector<Step> steps{{&definition, 0}};
    while (!steps.empty()) {
        Step& step = steps.back();
        if (step.next < step.of->calls.size()) {
            const FunctionDefinition* const called = step.of->calls[step.next].get();
            if (activations->of.count(called) || failed.count(called))
                ++step.next;
            else if (called->calls.empty())
                activate(step.of->calls[step.next++]);
            else
                steps.push_back({called, 0});
            continue;
        }
        steps.pop_back();
        if (!steps.empty()) activate(steps.back().of->calls[steps.back().next++]);
    }
}

Activation* Compiler::State::activate(const std::shared_ptr<const FunctionDefinition>& definition) {
    if (failed.count(definition.get())) throw Unresolved();
    const auto known = activations->of.find(definition.get());
    if (known != activations->of.end()) return known->second.get();
    if (callsOnly)
        calls.push_back(definition);
    else
        activateCalls(*definition);
    activations->of[definition.get()] = nullptr;
    ++quiet;  // warnings were given where it was defined
    std::unique_ptr<Activation> made = compile(*definition);
    --quiet;
    if (!made) {
        failed.insert(definition.get());
        throw Unresolved();
    }
    return (activations->of[definition.get()] = std::move(made)).get();
}

}  // namespace RTT::scripting::detail
