// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/unit_compiler.hpp>

#include <rtt/base/AttributeBase.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/types/SizeLimit.hpp>
#include <rtt/types/Types.hpp>

namespace RTT::scripting::detail {

void UnitCompiler::declare(const ast::Declaration& declaration, bool again) {
    for (const ast::Declarator& declarator : declaration.names) {
        try {
            switch (declaration.kind) {
                case ast::Declaration::Kind::Constant: declareConstant(declaration, declarator); break;
                case ast::Declaration::Kind::Alias: declareAlias(declaration, declarator); break;
                default:
                    if (declaration.type.text == "SendHandle")
                        declareHandle(declarator);
                    else
                        declareVariable(declaration, declarator, again);
            }
        } catch (const Unresolved&) {
            if (where_.toCome)
                for (const ast::Declarator& each : declaration.names) where_.toCome->miss(each.name.text);
            throw;
        }
    }
}

void UnitCompiler::addEntry(const ast::Identifier& name, Scope::Entry entry) {
    entry.at = name.at;
    if (entry.source) keep(entry.source);
    if (scope_->add(name.text, std::move(entry))) return;
    where_.sink->error(locate(name.at), "OPS111", "'" + name.text + "' is already declared in " + scope_->name())
        .note(locate(scope_->findHere(name.text)->at), "first declared here");
    throw Unresolved();
}

int UnitCompiler::sizeHint(const ast::Expression& size, const std::string& type, const ast::Identifier& name) {
    // Computed while compiling, because its value is needed here.
    Code code;
    UnitCompiler unit(state_, where_, code, *scope_);
    const Operand value = unit.expression(size);
    if (value.kind != Kind::Int && value.kind != Kind::UInt)
        error(size.at, "OPS112",
              "expected a number of elements (int) for '" + name.text + "', found a value of type " + typeName(value) +
                  "; write '= " + type + "(...)' to use a constructor");
    const Operand loaded = unit.load(value);
    unit.end();
    if (where_.checkOnly) return 1;
    Process process(code);
    if (process.runToEnd() != Process::Outcome::Finished)
        error(size.at, "OPS113",
              "the number of elements of '" + name.text + "' cannot be computed: " + process.message());
    const int count = *static_cast<const int*>(loaded.address);
    if (count < 0)
        error(size.at, "OPS114",
              "'" + name.text + "' cannot have " + std::to_string(count) +
                  " elements; the number is computed once, before the script runs");
    if (!types::isWithinSizeLimit(static_cast<std::size_t>(count)))
        error(size.at, "OPS114",
              "'" + name.text + "' cannot have " + types::beyondSizeLimit(static_cast<std::size_t>(count)));
    if (count == 0)
        warn(size.at, "OPS115",
             "'" + name.text + "' is made with 0 elements; the number is computed once, before the script runs");
    return count;
}

base::DataSourceBase::shared_ptr UnitCompiler::newVariable(const ast::Identifier& typeName, const ast::Identifier& name,
                                                           const ast::Expression* size) {
    const types::TypeInfo& info = type(typeName);
    Source source = info.buildValue();
    if (!source) error(typeName.at, "OPS116", "there can be no variable of type '" + typeName.text + "'");
    if (!size) return source;
    const int count = sizeHint(*size, typeName.text, name);
    try {
        const std::unique_ptr<base::AttributeBase> made(info.buildVariable(name.text, count));
        return made ? made->getDataSource() : source;
    } catch (const std::exception& thrown) {
        error(size->at, "OPS113",
              "'" + name.text + "' cannot have " + std::to_string(count) + " elements: " + thrown.what());
    }
}

void UnitCompiler::declareVariable(const ast::Declaration& declaration, const ast::Declarator& declarator, bool again) {
    const Scope::Entry* const known = again ? scope_->findHere(declarator.name.text) : nullptr;
    const bool reuse =
        known && known->loop == Scope::Entry::Loop::Left && known->source->getTypeInfo() == &type(declaration.type);
    Source source;
    if (reuse) {
        source = known->source;
    } else {
        source = newVariable(declaration.type, declarator.name, declarator.size.get());
        Scope::Entry entry;
        entry.source = source;
        addEntry(declarator.name, std::move(entry));
    }
    const Operand variable = fromSource(source, declarator.name.at);
    const std::string what = "variable '" + declarator.name.text + "'";
    if (declarator.value) store(variable, expression(*declarator.value), what);
    // Callers share activations, so variables are reset and do not show values of an earlier call.
    else if (function_)
        store(variable, fromSource(source->clone(), declarator.name.at), what);
}

void UnitCompiler::declareArgument(const ast::Function::Argument& argument) {
    Scope::Entry entry;
    entry.source = newVariable(argument.type, argument.name, argument.size.get());
    function_->arguments.push_back(entry.source);
    addEntry(argument.name, std::move(entry));
}

void UnitCompiler::functionHead(const ast::Function& tree) {
    begin(tree.name.at);
    for (const auto& argument : tree.arguments) declareArgument(argument);
    if (tree.type.text == "void") return;
    function_->result = newVariable(tree.type, tree.name, nullptr);
    store(fromSource(function_->result, tree.name.at), fromSource(function_->result->clone(), tree.name.at),
          "the result");
}

void UnitCompiler::function(const ast::Function& tree, bool withBody) {
    try {
        functionHead(tree);
        if (withBody) block(tree.body);
        end();
    } catch (const Unresolved&) {
        // The error was reported.
    }
}

void UnitCompiler::declareHandle(const ast::Declarator& declarator) {
    Scope::Entry entry;
    entry.handle = std::make_shared<Scope::Handle>();
    const std::shared_ptr<Scope::Handle> handle = entry.handle;
    addEntry(declarator.name, std::move(entry));
    if (declarator.value) sendInto(*handle, declarator.name.text, *declarator.value, declarator.name.at);
}

void UnitCompiler::declareConstant(const ast::Declaration& declaration, const ast::Declarator& declarator) {
    const std::string what = "constant '" + declarator.name.text + "'";
    const Source source = newVariable(declaration.type, declarator.name, declarator.size.get());
    Code code;
    UnitCompiler unit(state_, where_, code, *scope_);
    unit.store(fromSource(source, declarator.name.at), unit.expression(*declarator.value), what);
    unit.end();
    Process process(code);
    if (!where_.checkOnly && process.runToEnd() != Process::Outcome::Finished)
        error(declarator.value->at, "OPS117", "the value of " + what + " cannot be computed: " + process.message());
    const std::unique_ptr<base::AttributeBase> made(source->getTypeInfo()->buildConstant(declarator.name.text, source));
    Scope::Entry entry;
    entry.source = made ? made->getDataSource() : source;
    entry.constant = true;
    addEntry(declarator.name, std::move(entry));
}

void UnitCompiler::declareAlias(const ast::Declaration& declaration, const ast::Declarator& declarator) {
    const types::TypeInfo& info = type(declaration.type);
    const std::size_t before = code_.size();
    const Operand value = expression(*declarator.value);
    const bool same = value.kind != Kind::None && sourceOf(value)->getTypeInfo() == &info;
    if (!same)
        error(declarator.value->at, "OPS118",
              "alias '" + declarator.name.text + "' is for a value of type " + declaration.type.text + ", found " +
                  typeName(value));
    code_.truncate(before);  // because it is evaluated where it is used
    Scope::Entry entry;
    entry.alias = declarator.value.get();
    entry.scope = scope_;
    entry.file = where_.file;
    addEntry(declarator.name, std::move(entry));
}

}  // namespace RTT::scripting::detail
