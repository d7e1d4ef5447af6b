// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/unit_compiler.hpp>

#include <rtt/base/AttributeBase.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/types/SizeLimit.hpp>
#include <rtt/types/Types.hpp>

#include <diag/nearest_match.hpp>

namespace RTT::scripting::detail {

void DeclarationCompiler::compile(const ast::Declaration& declaration, bool again) {
    for (const ast::Declarator& declarator : declaration.names) {
        try {
            switch (declaration.kind) {
                case ast::Declaration::Kind::Constant: constant(declaration, declarator); break;
                case ast::Declaration::Kind::Alias: alias(declaration, declarator); break;
                default:
                    if (declaration.type.text == "SendHandle")
                        handle(declarator);
                    else
                        variable(declaration, declarator, again);
            }
        } catch (const Unresolved&) {
            if (where_.toCome)
                for (const ast::Declarator& each : declaration.names) where_.toCome->miss(each.name.text);
            throw;
        }
    }
}

void DeclarationCompiler::addEntry(const ast::Identifier& name, Scope::Entry entry) {
    entry.at = name.at;
    if (entry.source) code_.keepSource(entry.source);
    if (unit_.scope.add(name.text, std::move(entry))) return;
    where_.sink
        ->error(reporter_.locate(name.at), "OPS111", "'" + name.text + "' is already declared in " + unit_.scope.name())
        .note(reporter_.locate(unit_.scope.findHere(name.text)->at), "first declared here");
    throw Unresolved();
}

const types::TypeInfo& DeclarationCompiler::type(const ast::Identifier& name) {
    const types::TypeInfo* const found = types::Types()->type(name.text);
    if (!found)
        reporter_.error(name.at, "OPS110",
                        "type '" + name.text + "' is unknown" +
                            oroforge::diag::didYouMean(name.text, types::Types()->getDottedTypes()));
    return *found;
}

int DeclarationCompiler::sizeHint(const ast::Expression& size, const std::string& type, const ast::Identifier& name) {
    // Computed while compiling, because its value is needed here.
    Code code;
    UnitCompiler unit(unit_.state, where_, code, unit_.scope);
    const Operand value = unit.expressions.compile(size);
    if (value.kind != Kind::Int && value.kind != Kind::UInt)
        reporter_.error(size.at, "OPS112",
                        "expected a number of elements (int) for '" + name.text + "', found a value of type " +
                            typeName(value) + "; write '= " + type + "(...)' to use a constructor");
    const Operand loaded = unit.values.load(value);
    unit.statements.end();
    if (where_.checkOnly) return 1;
    Process process(code);
    if (process.runToEnd() != Process::Outcome::Finished)
        reporter_.error(size.at, "OPS113",
                        "the number of elements of '" + name.text + "' cannot be computed: " + process.message());
    const int count = *static_cast<const int*>(loaded.address);
    if (count < 0)
        reporter_.error(size.at, "OPS114",
                        "'" + name.text + "' cannot have " + std::to_string(count) +
                            " elements; the number is computed once, before the script runs");
    if (!types::isWithinSizeLimit(static_cast<std::size_t>(count)))
        reporter_.error(size.at, "OPS114",
                        "'" + name.text + "' cannot have " + types::beyondSizeLimit(static_cast<std::size_t>(count)));
    if (count == 0)
        reporter_.warn(
            size.at, "OPS115",
            "'" + name.text + "' is made with 0 elements; the number is computed once, before the script runs");
    return count;
}

base::DataSourceBase::shared_ptr DeclarationCompiler::newVariable(const ast::Identifier& typeName,
                                                                  const ast::Identifier& name,
                                                                  const ast::Expression* size) {
    const types::TypeInfo& info = type(typeName);
    Source source = info.buildValue();
    if (!source) reporter_.error(typeName.at, "OPS116", "there can be no variable of type '" + typeName.text + "'");
    if (!size) return source;
    const int count = sizeHint(*size, typeName.text, name);
    try {
        const std::unique_ptr<base::AttributeBase> made(info.buildVariable(name.text, count));
        return made ? made->getDataSource() : source;
    } catch (const std::exception& thrown) {
        reporter_.error(size->at, "OPS113",
                        "'" + name.text + "' cannot have " + std::to_string(count) + " elements: " + thrown.what());
    }
}

void DeclarationCompiler::variable(const ast::Declaration& declaration, const ast::Declarator& declarator, bool again) {
    const Scope::Entry* const known = again ? unit_.scope.findHere(declarator.name.text) : nullptr;
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
    const Operand variable = values_.fromSource(source, declarator.name.at);
    const std::string what = "variable '" + declarator.name.text + "'";
    if (declarator.value) values_.store(variable, unit_.expressions.compile(*declarator.value), what);
    // Callers share activations, so variables are reset and do not show values of an earlier call.
    else if (unit_.function)
        values_.store(variable, values_.fromSource(source->clone(), declarator.name.at), what);
}

void DeclarationCompiler::argument(const ast::Function::Argument& argument) {
    Scope::Entry entry;
    entry.source = newVariable(argument.type, argument.name, argument.size.get());
    unit_.function->arguments.push_back(entry.source);
    addEntry(argument.name, std::move(entry));
}

void DeclarationCompiler::functionHead(const ast::Function& tree) {
    code_.beginStatement(tree.name.at);
    for (const auto& each : tree.arguments) argument(each);
    if (tree.type.text == "void") return;
    unit_.function->result = newVariable(tree.type, tree.name, nullptr);
    values_.store(values_.fromSource(unit_.function->result, tree.name.at),
                  values_.fromSource(unit_.function->result->clone(), tree.name.at), "the result");
}

void DeclarationCompiler::handle(const ast::Declarator& declarator) {
    Scope::Entry entry;
    entry.handle = std::make_shared<Scope::Handle>();
    const std::shared_ptr<Scope::Handle> handle = entry.handle;
    addEntry(declarator.name, std::move(entry));
    if (declarator.value) unit_.sends.sendInto(*handle, declarator.name.text, *declarator.value, declarator.name.at);
}

void DeclarationCompiler::constant(const ast::Declaration& declaration, const ast::Declarator& declarator) {
    const std::string what = "constant '" + declarator.name.text + "'";
    const Source source = newVariable(declaration.type, declarator.name, declarator.size.get());
    Code code;
    UnitCompiler unit(unit_.state, where_, code, unit_.scope);
    unit.values.store(values_.fromSource(source, declarator.name.at), unit.expressions.compile(*declarator.value),
                      what);
    unit.statements.end();
    Process process(code);
    if (!where_.checkOnly && process.runToEnd() != Process::Outcome::Finished)
        reporter_.error(declarator.value->at, "OPS117",
                        "the value of " + what + " cannot be computed: " + process.message());
    const std::unique_ptr<base::AttributeBase> made(source->getTypeInfo()->buildConstant(declarator.name.text, source));
    Scope::Entry entry;
    entry.source = made ? made->getDataSource() : source;
    entry.constant = true;
    addEntry(declarator.name, std::move(entry));
}

void DeclarationCompiler::alias(const ast::Declaration& declaration, const ast::Declarator& declarator) {
    const types::TypeInfo& info = type(declaration.type);
    const std::size_t before = code_.size();
    const Operand value = unit_.expressions.compile(*declarator.value);
    const bool same = value.kind != Kind::None && values_.sourceOf(value)->getTypeInfo() == &info;
    if (!same)
        reporter_.error(declarator.value->at, "OPS118",
                        "alias '" + declarator.name.text + "' is for a value of type " + declaration.type.text +
                            ", found " + typeName(value));
    code_.truncate(before);  // because it is evaluated where it is used
    Scope::Entry entry;
    entry.alias = declarator.value.get();
    entry.scope = &unit_.scope;
    entry.file = where_.file;
    addEntry(declarator.name, std::move(entry));
}

}  // namespace RTT::scripting::detail
