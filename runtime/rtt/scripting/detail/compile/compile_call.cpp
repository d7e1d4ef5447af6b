// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/call_words.hpp>
#include <rtt/scripting/detail/compile/unit_compiler.hpp>

#include <rtt/FactoryExceptions.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/internal/calls/operation_signature.hpp>
#include <rtt/scripting/detail/compile/arithmetic.hpp>
#include <rtt/scripting/detail/function/function_operation.hpp>
#include <rtt/scripting/detail/execute/instructions.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/Types.hpp>

namespace RTT::scripting::detail {

using internal::OperationSignature;

namespace {

/** True if the operation changes that argument by reference. */
bool isOutput(const OperationSignature& signature, std::size_t index) {
    return index < signature.arguments.size() && signature.arguments[index].isOutput();
}

Kind kindOfArgument(const OperationSignature::Value& argument) {
    return argument.type ? kindOf(argument.type->getTypeId()) : Kind::Other;
}

bool isConverted(const OperationSignature::Value& argument, const Operand& value) {
    const Kind wanted = kindOfArgument(argument);
    return wanted != value.kind && conversion(value.kind, wanted) != Conversion::None && !argument.isOutput();
}

}  // namespace

/** Evaluates arguments from left to right, because a later one may call what changes an earlier one. Those that
    `isOutput` are variables. */
std::vector<Operand> CallCompiler::values(const ast::Expressions& expressions, const IsOutput& isOutput,
                                          const OperationSignature* signature) {
    std::vector<Operand> values;
    const unsigned first = unit_.executions;
    for (const auto& argument : expressions) {
        const std::size_t before = code_.size();
        const unsigned executions = unit_.executions;
        const types::TypeInfo* const wanted = signature && values.size() < signature->arguments.size()
                                                  ? signature->arguments[values.size()].type
                                                  : nullptr;
        unit_.unknownName.expectText(
            wanted && wanted->getTypeName() == "string" ? std::get_if<ast::Name>(&argument->what) : nullptr);
        Operand value = unit_.expressions.compile(*argument);
        if (value.kind == Kind::None) reporter_.error(argument->at, "OPS140", "found an argument without value");
        // An earlier call is made where its value is used, which is after this computation.
        const bool overtakes = executions != first && code_.size() != before;
        if (unit_.executions != executions || overtakes) {
            std::size_t at = before;
            for (std::size_t i = 0; i != values.size(); ++i) {
                if (isOutput(i)) continue;
                const std::size_t size = code_.size();
                values[i] = values_.taken(values[i], at);
                at += code_.size() - size;
            }
        }
        values.push_back(std::move(value));
    }
    return values;
}

OperationInterfacePart::Args CallCompiler::arguments(const ast::Name& name, const OperationInterfacePart& part) {
    const unsigned executions = unit_.executions;
    const OperationSignature signature = part.signature();
    auto given = values(
        name.arguments, [&](std::size_t index) { return isOutput(signature, index); }, &signature);
    OperationInterfacePart::Args sources;
    const bool fits = given.size() == signature.arguments.size();
    // Conversions happen before the call, so calls in earlier arguments must happen first.
    for (std::size_t i = 1; fits && unit_.executions != executions && i < given.size(); ++i) {
        if (!isConverted(signature.arguments[i], given[i])) continue;
        for (std::size_t j = 0; j != i; ++j)
            if (!isOutput(signature, j)) given[j] = values_.taken(given[j], code_.size());
    }
    for (std::size_t i = 0; i != given.size(); ++i)
        sources.push_back(fits ? argument(name, signature, i, given) : values_.sourceOf(given[i]));
    return sources;
}

base::DataSourceBase::shared_ptr CallCompiler::argument(const ast::Name& name, const OperationSignature& signature,
                                                        std::size_t index, const std::vector<Operand>& values) {
    const Operand& value = values[index];
    const OperationSignature::Value& argument = signature.arguments[index];
    if (!argument.isOutput() && isEnum(argument.type))
        return reporter_.watched(value.at, [&] { return argument.type->convert(values_.sourceOf(value)); });
    if (!isConverted(argument, value)) return values_.sourceOf(value);
    const Kind wanted = kindOfArgument(argument);
    if (!value.constant || !isReal(value.kind) || isReal(wanted))
        return values_.sourceOf(values_.loadAs(value, wanted));
    // A fractional number where an integer is expected often means that two arguments were swapped.
    std::string hint;
    for (std::size_t i = index == 0 ? 0 : index - 1; i != values.size() && i <= index + 1; ++i) {
        const OperationSignature::Value& other = signature.arguments[i];
        if (i != index && isReal(kindOfArgument(other)) && !isReal(values[i].kind) && isDirect(values[i].kind))
            hint = "argument " + std::to_string(i + 1) + " (" + other.name + ") is of type " + other.text() +
                   ": are the two swapped?";
    }
    reporter_.warn(value.at, "OPS152",
                   "argument " + std::to_string(index + 1) + " (" + argument.name + ") of '" + joined(name.parts) +
                       "' is a whole number (" + argument.text() + "): what is given loses its fraction",
                   hint);
    return values_.sourceOf(values_.loadAs(value, wanted, false));  // already reported
}

Callable CallCompiler::found(const Parts& parts, std::size_t count, const NameCompiler::Nodes& nodes,
                             bool toSend) const {
    Callable found;
    const std::string& name = parts[count - 1].text;
    std::shared_ptr<const FunctionDefinition> function;
    if (count == 1 && where_.functions && !toSend) {
        const auto known = where_.functions->find(name);
        if (known != where_.functions->end()) function = known->second;
        if (function && function->tree->scope == ast::Function::Scope::Exported) {
            found.function = function;
            return found;
        }
    }
    for (const NameCompiler::Node& node : nodes)
        if (node.used == count - 1) {
            found.part = node.service->getPart(name);
            found.of = node.service.get();
        }
    if (found.part || count != 1) return found;
    found.of = nullptr;
    found.part = internal::GlobalService::Instance()->getPart(name);
    if (found.part) return found;
    found.function = function;
    if (!function && where_.component->provides()->hasService("scripting")) {
        found.of = where_.component->provides()->getService("scripting").get();
        found.part = found.of->getPart(name);
    }
    // In a state machine, `stop()` is the component's operation.
    if (!function && !found.part && where_.service) {
        found.of = where_.service;
        found.part = found.of->getPart(name);
    }
    return found;
}

Callable CallCompiler::callable(const Parts& parts, std::size_t count, const NameCompiler::Nodes& nodes,
                                bool toSend) const {
    const Callable called = found(parts, count, nodes, toSend);
    if (where_.toCome && (called.function || dynamic_cast<const FunctionSignature*>(called.part)) &&
        where_.toCome->mayReplace(parts[count - 1].text, !dynamic_cast<const FunctionPart*>(called.part)))
        throw Unresolved();
    return called;
}

bool CallCompiler::call(const ast::Name& name, const NameCompiler::Nodes& nodes, ast::Place at, Operand& result) {
    const std::size_t count = name.parts.size();
    if (count == 1 && unit_.function && unit_.function->name == name.parts[0].text && name.called)
        failRecursive(unit_.function->name, at);
    const Callable whole = callable(name.parts, count, nodes, false);
    if (whole.function || whole.part) {
        result = call(whole, name, at);
        return true;
    }
    if (count == 1) return false;
    const std::string& last = name.parts.back().text;
    if (last != "send" && last != "call" && last != "cmd") return false;
    const Callable called = callable(name.parts, count - 1, nodes, last != "call");
    if (!called.function && !called.part) return false;
    result = called.function || last == "call" ? call(called, name, at)
             : last == "send"                  ? unit_.sends.sent(called, name, at)
                                               : unit_.sends.command(called, name, at);
    return true;
}

base::DataSourceBase::shared_ptr CallCompiler::made(const ast::Name& name, ast::Place at,
                                                    const OperationInterfacePart& part,
                                                    const std::function<Source()>& make) {
    const auto argumentAt = [&](int number) {
        const auto index = static_cast<std::size_t>(number - 1);
        return number > 0 && index < name.arguments.size() ? name.arguments[index]->at : at;
    };
    const std::string called = "'" + joined(name.parts) + "'";
    const std::string& last = name.parts.back().text;
    // collect() has variables as arguments, and no declaration that says so.
    const auto becomesText = [&](const std::string& wanted, const std::string& found, int number) {
        const types::TypeInfo* const type = types::Types()->type(found);
        return plainType(wanted) == "string" && type && isDirect(kindOf(type->getTypeId())) && last != "collect" &&
               last != "collectIfDone" && !isOutput(part.signature(), static_cast<std::size_t>(number - 1));
    };
    try {
        return reporter_.watched(at, make);
    } catch (const wrong_number_of_args_exception& e) {
        reporter_.error(at, "OPS142",
                        called + " expects " + counted(static_cast<std::size_t>(e.wanted)) + ", found " +
                            counted(static_cast<std::size_t>(e.received)),
                        "it is '" + declarationOf(part) + "'");
    } catch (const wrong_types_of_args_exception& e) {
        reporter_.error(argumentAt(e.whicharg), "OPS143",
                        "argument " + std::to_string(e.whicharg) + " of " + called + " must be of type " +
                            plainType(e.expected_) + ", found " + e.received_,
                        becomesText(e.expected_, e.received_, e.whicharg) ? "'\"\" + x' is the text of x" : "");
    } catch (const non_lvalue_args_exception& e) {
        reporter_.error(argumentAt(e.whicharg), "OPS144",
                        "argument " + std::to_string(e.whicharg) + " of " + called +
                            " is assigned by the call: expected a variable, found a value of type " + e.received_);
    } catch (const std::exception& e) {
        reporter_.error(at, "OPS145", "cannot call " + called + ": " + e.what());
    }
}

Operand CallCompiler::call(const Callable& called, const ast::Name& name, ast::Place at) {
    return called.function ? callFunction(called.function, name, at) : callOperation(called, name, at);
}

Operand CallCompiler::callOperation(const Callable& called, const ast::Name& name, ast::Place at) {
    OperationInterfacePart& part = *called.part;
    const auto sources = arguments(name, part);
    ++unit_.executions;
    code_.keep(OperationInterfacePart::hold(&part));
    const Source call = made(name, at, part, [&] { return part.produce(sources, where_.caller); });
    return values_.fromSource(unit_.sends.told(call, called, name, at), at);
}

bool CallCompiler::construct(const ast::Name& name, ast::Place at, Operand& result) {
    const std::string wanted = joined(name.parts);
    const types::TypeInfo* const type = types::Types()->type(wanted);
    if (!type) return false;
    OperationInterfacePart::Args sources;
    for (const Operand& value : values(name.arguments, [](std::size_t) { return false; }))
        sources.push_back(values_.sourceOf(value));
    const ast::Place first = name.arguments.empty() ? at : name.arguments[0]->at;
    const Source value =
        reporter_.watched(name.arguments.size() == 1 ? first : at, [&] { return type->construct(sources); });
    if (!value)
        reporter_.error(at, "OPS146", "there is no constructor " + signature(wanted, sources), elementsOf(*type));
    result = values_.fromSource(value, at);
    return true;
}

void CallCompiler::failRecursive(const std::string& function, ast::Place at) {
    reporter_.error(at, "OPS151", "function '" + function + "' calls itself, directly or through another one");
}

Operand CallCompiler::callFunction(const std::shared_ptr<const FunctionDefinition>& definition, const ast::Name& name,
                                   ast::Place at) {
    const FunctionDefinition& function = *definition;
    Activation* const activation = unit_.state.activate(definition);
    if (!activation) failRecursive(function.name, at);
    if (name.arguments.size() != activation->arguments.size())
        reporter_.error(at, "OPS142",
                        "'" + function.name + "' expects " + counted(activation->arguments.size()) + ", found " +
                            counted(name.arguments.size()));
    const auto given = values(name.arguments, [](std::size_t) { return false; });
    for (std::size_t i = 0; i != given.size(); ++i)
        values_.store(values_.fromSource(activation->arguments[i], given[i].at), given[i],
                      "argument " + std::to_string(i + 1) + " of '" + function.name + "'");
    code_.add(&instructions::enter, nullptr, nullptr, activation);
    ++unit_.executions;
    Operand result;
    result.at = at;
    if (!activation->result) return result;
    // A copy, because the next call overwrites the result.
    const Operand returned = values_.fromSource(activation->result, at);
    if (returned.address)
        return values_.computedBy(conversionAction(returned.kind, returned.kind), returned.address, nullptr,
                                  returned.kind, at);
    result = values_.fromSource(activation->result->clone(), at);
    values_.store(result, returned, "the result");
    result.computed = true;
    return result;
}

}  // namespace RTT::scripting::detail
