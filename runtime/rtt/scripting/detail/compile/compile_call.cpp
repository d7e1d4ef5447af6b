// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calls of operations, constructors and functions of scripts; compile_send.cpp has calls that are sent.
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
std::vector<Operand> UnitCompiler::values(const ast::Expressions& expressions, const IsOutput& isOutput,
                                          const OperationSignature* signature) {
    std::vector<Operand> values;
    const unsigned first = executions_;
    for (const auto& argument : expressions) {
        const std::size_t before = code_.size();
        const unsigned executions = executions_;
        const types::TypeInfo* const wanted = signature && values.size() < signature->arguments.size()
                                                  ? signature->arguments[values.size()].type
                                                  : nullptr;
        text_ = wanted && wanted->getTypeName() == "string" ? std::get_if<ast::Name>(&argument->what) : nullptr;
        Operand value = expression(*argument);
        if (value.kind == Kind::None) error(argument->at, "OPS140", "found an argument without value");
        // An earlier call is made where its value is used, which is after this computation.
        const bool overtakes = executions != first && code_.size() != before;
        if (executions_ != executions || overtakes) {
            std::size_t at = before;
            for (std::size_t i = 0; i != values.size(); ++i) {
                if (isOutput(i)) continue;
                const std::size_t size = code_.size();
                values[i] = taken(values[i], at);
                at += code_.size() - size;
            }
        }
        values.push_back(std::move(value));
    }
    return values;
}

/** The arguments, with numbers converted to the types of the operation. */
OperationInterfacePart::Args UnitCompiler::arguments(const ast::Name& name, const OperationInterfacePart& part) {
    const unsigned executions = executions_;
    const OperationSignature signature = part.signature();
    auto given = values(
        name.arguments, [&](std::size_t index) { return isOutput(signature, index); }, &signature);
    OperationInterfacePart::Args sources;
    const bool fits = given.size() == signature.arguments.size();
    // Conversions happen before the call, so calls in earlier arguments must happen first.
    for (std::size_t i = 1; fits && executions_ != executions && i < given.size(); ++i) {
        if (!isConverted(signature.arguments[i], given[i])) continue;
        for (std::size_t j = 0; j != i; ++j)
            if (!isOutput(signature, j)) given[j] = taken(given[j], code_.size());
    }
    for (std::size_t i = 0; i != given.size(); ++i)
        sources.push_back(fits ? argument(name, signature, i, given) : sourceOf(given[i]));
    return sources;
}

base::DataSourceBase::shared_ptr UnitCompiler::argument(const ast::Name& name, const OperationSignature& signature,
                                                        std::size_t index, const std::vector<Operand>& values) {
    const Operand& value = values[index];
    const OperationSignature::Value& argument = signature.arguments[index];
    if (!argument.isOutput() && isEnum(argument.type))
        return watched(value.at, [&] { return argument.type->convert(sourceOf(value)); });
    if (!isConverted(argument, value)) return sourceOf(value);
    const Kind wanted = kindOfArgument(argument);
    if (!value.constant || !isReal(value.kind) || isReal(wanted)) return sourceOf(loadAs(value, wanted));
    // A fractional number where an integer is expected often means that two arguments were swapped.
    std::string hint;
    for (std::size_t i = index == 0 ? 0 : index - 1; i != values.size() && i <= index + 1; ++i) {
        const OperationSignature::Value& other = signature.arguments[i];
        if (i != index && isReal(kindOfArgument(other)) && !isReal(values[i].kind) && isDirect(values[i].kind))
            hint = "argument " + std::to_string(i + 1) + " (" + other.name + ") is of type " + other.text() +
                   ": are the two swapped?";
    }
    warn(value.at, "OPS152",
         "argument " + std::to_string(index + 1) + " (" + argument.name + ") of '" + joined(name.parts) +
             "' is a whole number (" + argument.text() + "): what is given loses its fraction",
         hint);
    ++aliases_;  // already reported
    const Source whole = sourceOf(loadAs(value, wanted));
    --aliases_;
    return whole;
}

UnitCompiler::Callable UnitCompiler::found(const Parts& parts, std::size_t count, const std::vector<Node>& nodes,
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
    for (const Node& node : nodes)
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

/** The operation or function that the first `count` parts name. To be sent, a function must be an operation. */
UnitCompiler::Callable UnitCompiler::callable(const Parts& parts, std::size_t count, const std::vector<Node>& nodes,
                                              bool toSend) const {
    const Callable called = found(parts, count, nodes, toSend);
    if (where_.toCome && (called.function || dynamic_cast<const FunctionSignature*>(called.part)) &&
        where_.toCome->mayReplace(parts[count - 1].text, !dynamic_cast<const FunctionPart*>(called.part)))
        throw Unresolved();
    return called;
}

bool UnitCompiler::call(const ast::Name& name, const std::vector<Node>& nodes, ast::Place at, Operand& result) {
    const std::size_t count = name.parts.size();
    if (count == 1 && function_ && function_->name == name.parts[0].text && name.called)
        failRecursive(function_->name, at);
    const Callable whole = callable(name.parts, count, nodes, false);
    if (whole.function) {
        result = callFunction(whole.function, name, at);
        return true;
    }
    if (whole.part) {
        result = callOperation(whole, name, at);
        return true;
    }
    if (count == 1) return false;
    const std::string& last = name.parts.back().text;
    if (last != "send" && last != "call" && last != "cmd") return false;
    const Callable called = callable(name.parts, count - 1, nodes, last != "call");
    if (called.function) {
        result = callFunction(called.function, name, at);
    } else if (called.part) {
        result = last == "call"   ? callOperation(called, name, at)
                 : last == "send" ? sent(called, name, at)
                                  : command(called, name, at);
    } else {
        return false;
    }
    return true;
}

/** What `make` makes for a call of `name`; reports errors in its arguments. */
UnitCompiler::Source UnitCompiler::made(const ast::Name& name, ast::Place at, const OperationInterfacePart& part,
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
        return watched(at, make);
    } catch (const wrong_number_of_args_exception& e) {
        error(at, "OPS142",
              called + " expects " + counted(static_cast<std::size_t>(e.wanted)) + ", found " +
                  counted(static_cast<std::size_t>(e.received)),
              "it is '" + declarationOf(part) + "'");
    } catch (const wrong_types_of_args_exception& e) {
        error(argumentAt(e.whicharg), "OPS143",
              "argument " + std::to_string(e.whicharg) + " of " + called + " must be of type " +
                  plainType(e.expected_) + ", found " + e.received_,
              becomesText(e.expected_, e.received_, e.whicharg) ? "'\"\" + x' is the text of x" : "");
    } catch (const non_lvalue_args_exception& e) {
        error(argumentAt(e.whicharg), "OPS144",
              "argument " + std::to_string(e.whicharg) + " of " + called +
                  " is assigned by the call: expected a variable, found a value of type " + e.received_);
    } catch (const std::exception& e) {
        error(at, "OPS145", "cannot call " + called + ": " + e.what());
    }
}

Operand UnitCompiler::callOperation(const Callable& called, const ast::Name& name, ast::Place at) {
    OperationInterfacePart& part = *called.part;
    const auto sources = arguments(name, part);
    ++executions_;
    code_.keep(OperationInterfacePart::hold(&part));
    const Source call = made(name, at, part, [&] { return part.produce(sources, where_.caller); });
    return fromSource(told(call, called, name, at), at);
}

bool UnitCompiler::construct(const ast::Name& name, ast::Place at, Operand& result) {
    const std::string wanted = joined(name.parts);
    const types::TypeInfo* const type = types::Types()->type(wanted);
    if (!type) return false;
    OperationInterfacePart::Args sources;
    for (const Operand& value : values(name.arguments, [](std::size_t) { return false; }))
        sources.push_back(sourceOf(value));
    const ast::Place first = name.arguments.empty() ? at : name.arguments[0]->at;
    const Source value = watched(name.arguments.size() == 1 ? first : at, [&] { return type->construct(sources); });
    if (!value) error(at, "OPS146", "there is no constructor " + signature(wanted, sources), elementsOf(*type));
    result = fromSource(value, at);
    return true;
}

void UnitCompiler::failRecursive(const std::string& function, ast::Place at) {
    error(at, "OPS151", "function '" + function + "' calls itself, directly or through another one");
}

Operand UnitCompiler::callFunction(const std::shared_ptr<const FunctionDefinition>& definition, const ast::Name& name,
                                   ast::Place at) {
    const FunctionDefinition& function = *definition;
    Activation* const activation = state_.activate(definition);
    if (!activation) failRecursive(function.name, at);
    if (name.arguments.size() != activation->arguments.size())
        error(at, "OPS142",
              "'" + function.name + "' expects " + counted(activation->arguments.size()) + ", found " +
                  counted(name.arguments.size()));
    const auto given = values(name.arguments, [](std::size_t) { return false; });
    for (std::size_t i = 0; i != given.size(); ++i)
        store(fromSource(activation->arguments[i], given[i].at), given[i],
              "argument " + std::to_string(i + 1) + " of '" + function.name + "'");
    emit(&instructions::enter, nullptr, nullptr, activation);
    ++executions_;
    Operand result;
    result.at = at;
    if (!activation->result) return result;
    // A copy, because the next call overwrites the result.
    const Operand returned = fromSource(activation->result, at);
    if (returned.address)
        return computedBy(conversionAction(returned.kind, returned.kind), returned.address, nullptr, returned.kind, at);
    result = fromSource(activation->result->clone(), at);
    store(result, returned, "the result");
    result.computed = true;
    return result;
}

}  // namespace RTT::scripting::detail
