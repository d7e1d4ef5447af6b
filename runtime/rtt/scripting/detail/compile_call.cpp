// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calls of operations, constructors and functions of scripts.
#include <rtt/scripting/detail/call_words.hpp>
#include <rtt/scripting/detail/unit.hpp>

#include <rtt/FactoryExceptions.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/FailureReport.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/scripting/detail/arithmetic.hpp>
#include <rtt/scripting/detail/function_operation.hpp>
#include <rtt/scripting/detail/instructions.hpp>
#include <rtt/scripting/detail/told_call.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/Types.hpp>

namespace RTT {
namespace scripting {
namespace detail {

/** From left to right: what a later argument calls may change what an earlier one is. Those that `isOutput` are variables. */
std::vector<Operand> Unit::values(const ast::Expressions& expressions, const IsOutput& isOutput,
                                  const OperationInterfacePart* part) {
    std::vector<Operand> values;
    const unsigned first = executions_;
    for (const auto& argument : expressions) {
        const std::size_t before = code_.size();
        const unsigned executions = executions_;
        const types::TypeInfo* const wanted = part && values.size() < part->arity()
                                                  ? part->getArgumentType(static_cast<unsigned>(values.size()) + 1)
                                                  : nullptr;
        text_ = wanted && wanted->getTypeName() == "string" ? std::get_if<ast::Name>(&argument->what) : nullptr;
        Operand value = expression(*argument);
        if (value.kind == Kind::None) error(argument->at, "OPS140", "found an argument without value");
        // A call before it is made where its value is used: after what is computed here.
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

/** What an operation changes by reference. */
bool Unit::isOutput(const OperationInterfacePart& part, std::size_t index) {
    const auto descriptions = part.getArgumentList();
    return index < descriptions.size() && isChanged(descriptions[index].type);
}

/** Converted to what the operation takes, as far as conversions of numbers go. */
OperationInterfacePart::Args Unit::arguments(const ast::Name& name, const OperationInterfacePart& part) {
    const unsigned executions = executions_;
    auto given = values(
        name.arguments, [&](std::size_t index) { return isOutput(part, index); }, &part);
    OperationInterfacePart::Args sources;
    const bool fits = given.size() == part.arity();
    // What is converted is so before the call, and what is called in front of it has to come first.
    for (unsigned i = 1; fits && executions_ != executions && i < given.size(); ++i) {
        if (!isConverted(part, i, given[i])) continue;
        for (unsigned j = 0; j != i; ++j)
            if (!isOutput(part, j)) given[j] = taken(given[j], code_.size());
    }
    for (unsigned i = 0; i != given.size(); ++i)
        sources.push_back(fits ? argument(name, part, i, given) : sourceOf(given[i]));
    return sources;
}

Kind Unit::wantedKind(const OperationInterfacePart& part, unsigned index) {
    const types::TypeInfo* const type = part.getArgumentType(index + 1);
    return type ? kindOf(type->getTypeId()) : Kind::Other;
}

bool Unit::isConverted(const OperationInterfacePart& part, unsigned index, const Operand& value) {
    const Kind wanted = wantedKind(part, index);
    return wanted != value.kind && conversion(value.kind, wanted) != Conversion::None && !isOutput(part, index);
}

base::DataSourceBase::shared_ptr Unit::argument(const ast::Name& name, const OperationInterfacePart& part,
                                                unsigned index, const std::vector<Operand>& values) {
    const Operand& value = values[index];
    if (!isConverted(part, index, value)) return sourceOf(value);
    const Kind wanted = wantedKind(part, index);
    const auto descriptions = part.getArgumentList();
    if (!value.constant || !isReal(value.kind) || isReal(wanted)) return sourceOf(loadAs(value, wanted));
    // A number with a fraction where a whole one is expected: often two arguments were swapped.
    std::string hint;
    for (unsigned i = index == 0 ? 0 : index - 1; i != values.size() && i <= index + 1; ++i)
        if (i != index && isReal(wantedKind(part, i)) && !isReal(values[i].kind) && isDirect(values[i].kind))
            hint = "argument " + std::to_string(i + 1) + " (" + descriptions[i].name + ") is of type " +
                   descriptions[i].type + ": are the two swapped?";
    warn(value.at, "OPS152",
         "argument " + std::to_string(index + 1) + " (" + descriptions[index].name + ") of '" + joined(name.parts) +
             "' is a whole number (" + descriptions[index].type + "): what is given loses its fraction",
         hint);
    ++aliases_;  // said
    const Source whole = sourceOf(loadAs(value, wanted));
    --aliases_;
    return whole;
}

Unit::Callable Unit::found(const Parts& parts, std::size_t count, const std::vector<Node>& nodes, bool toSend) const {
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
            found.of = node.service->getOwner();
        }
    if (found.part || count != 1) return found;
    found.of = nullptr;
    found.part = internal::GlobalService::Instance()->getPart(name);
    if (found.part) return found;
    found.function = function;
    if (!function && where_.component->provides()->hasService("scripting"))
        found.part = where_.component->provides()->getService("scripting")->getPart(name);
    // `stop()` in a state machine is the component's.
    if (!function && !found.part && where_.service) found.part = where_.service->getPart(name);
    return found;
}

/** The operation or function that the first `count` parts name. To be sent, a function is an operation, too. */
Unit::Callable Unit::callable(const Parts& parts, std::size_t count, const std::vector<Node>& nodes,
                              bool toSend) const {
    const Callable called = found(parts, count, nodes, toSend);
    if (where_.toCome && (called.function || dynamic_cast<const FunctionSignature*>(called.part)) &&
        where_.toCome->mayReplace(parts[count - 1].text, !dynamic_cast<const FunctionPart*>(called.part)))
        throw Unresolved();
    return called;
}

bool Unit::call(const ast::Name& name, const std::vector<Node>& nodes, ast::Place at, Operand& result) {
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
                 : last == "send" ? sent(*called.part, name, at)
                                  : command(*called.part, name, at);
    } else {
        return false;
    }
    return true;
}

/** What `make` makes for a call of `name`; says what is wrong with its arguments. */
template <class Make>
base::DataSourceBase::shared_ptr Unit::made(const ast::Name& name, ast::Place at, const OperationInterfacePart& part,
                                            Make make) {
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
               last != "collectIfDone" && !isOutput(part, static_cast<std::size_t>(number - 1));
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

Operand Unit::callOperation(const Callable& called, const ast::Name& name, ast::Place at) {
    OperationInterfacePart& part = *called.part;
    const auto sources = arguments(name, part);
    ++executions_;
    code_.keep(OperationInterfacePart::hold(&part));
    const Source call = made(name, at, part, [&] { return part.produce(sources, where_.caller); });
    return fromSource(told(call, called, name, at), at);
}

/** The call, or one that tells where it stands if it fails. */
Unit::Source Unit::told(Source call, const Callable& called, const ast::Name& name, ast::Place at) const {
    const bool gives = called.of ? internal::FailureReport::comesFrom(*called.of)
                                 : called.part == internal::GlobalService::Instance()->getPart("require");
    if (!gives) return call;
    internal::DataSource<bool>* const success = internal::DataSource<bool>::narrow(call.get());
    if (!success) return call;
    // An alias may stand in another file.
    const bool isHere = where_.text && !alias_;
    return new ToldCall(success, locate(at), isHere ? lineOf(*where_.text, at.line) : "", ignored_.count(&name) != 0);
}

Operand Unit::sent(OperationInterfacePart& part, const ast::Name& name, ast::Place at) {
    const auto sources = arguments(name, part);
    ++executions_;
    code_.keep(OperationInterfacePart::hold(&part));
    Operand result = fromSource(made(name, at, part, [&] { return part.produceSend(sources, where_.caller); }), at);
    result.sent = true;
    return result;
}

/** Sends; then the program goes on with its next step until the call is done. The value is the SendStatus. */
Operand Unit::command(OperationInterfacePart& part, const ast::Name& name, ast::Place at) {
    const Operand call = sent(part, name, at);
    const Source handle = made(name, at, part, [&] { return part.produceHandle(); });
    Operand target = fromSource(handle, at);
    store(target, call, "the handle");
    const Source status = made(
        name, at, part, [&] { return part.produceCollect({handle}, new internal::ConstantDataSource<bool>(false)); });
    auto* const polled = internal::DataSource<SendStatus>::narrow(keep(status));
    if (!polled) error(at, "OPS145", "cannot wait for '" + joined(name.parts) + "'");
    emit(&instructions::await, nullptr, nullptr, polled);
    const Source value = new internal::ValueDataSource<SendStatus>(SendNotReady);
    // Not collected again: the source keeps what it gave last.
    Operand result = fromSource(value, at);
    std::shared_ptr<base::ActionInterface> copy(
        value->updateAction(keep(new internal::ConstReferenceDataSource<SendStatus>(polled->rvalue()))));
    emit(&instructions::perform, nullptr, nullptr, copy.get());
    code_.keep(std::move(copy));
    return result;
}

bool Unit::construct(const ast::Name& name, ast::Place at, Operand& result) {
    const std::string wanted = joined(name.parts);
    const types::TypeInfo* const type = types::Types()->type(wanted);
    if (!type) return false;
    OperationInterfacePart::Args sources;
    for (const Operand& value : values(name.arguments, [](std::size_t) { return false; }))
        sources.push_back(sourceOf(value));
    const Source value = type->construct(sources);
    if (!value) error(at, "OPS146", "there is no constructor " + signature(wanted, sources), elementsOf(*type));
    result = fromSource(value, at);
    return true;
}

namespace {

/** What `make` makes; in its exceptions the first argument, which the script does not write, is not counted. */
template <class Make>
auto withoutFirst(Make make) -> decltype(make()) {
    try {
        return make();
    } catch (wrong_types_of_args_exception& e) {
        --e.whicharg;
        throw;
    } catch (non_lvalue_args_exception& e) {
        --e.whicharg;
        throw;
    }
}

}  // namespace

bool Unit::handleCall(const ast::Name& name, ast::Place at, Operand& result) {
    if (name.parts.size() != 2) return false;
    const std::string& what = name.parts[1].text;
    const bool blocking = what == "collect";
    if (!blocking && what != "collectIfDone") return false;
    const Scope::Entry* const entry = declared(name.parts[0].text);
    if (!entry) return false;
    const std::string handle = "'" + name.parts[0].text + "'";
    if (!entry->handle)
        error(name.parts[0].at, "OPS147", "expected a SendHandle before '." + what + "', " + handle + " is none");
    const auto operation = entry->handle->operation();
    const Source handleSource = entry->handle->source();
    if (!operation || !handleSource) failUnsent(name.parts[0]);
    OperationInterfacePart::Args sources{handleSource};
    for (const Operand& value : values(name.arguments, [](std::size_t) { return true; }))
        sources.push_back(sourceOf(value));
    const OperationInterfacePart& part = *operation;
    const unsigned wanted = part.collectArity();
    if (sources.size() != 1 && sources.size() != wanted + 1)
        error(at, "OPS142",
              "'" + joined(name.parts) + "' expects " + counted(wanted) + " or none, found " +
                  counted(sources.size() - 1));
    const auto collected = [&] {
        return withoutFirst(
            [&] { return part.produceCollect(sources, new internal::ConstantDataSource<bool>(blocking)); });
    };
    result = fromSource(made(name, at, part, collected), at);
    ++executions_;
    return true;
}

bool Unit::assignHandle(const ast::Assignment& assignment, ast::Place at, Operand& result) {
    const auto* const to = std::get_if<ast::Name>(&assignment.to->what);
    if (!to || to->called || to->parts.size() != 1) return false;
    const Scope::Entry* const entry = declared(to->parts[0].text);
    if (!entry || !entry->handle) return false;
    result = sendInto(*entry->handle, to->parts[0].text, *assignment.value, at);
    return true;
}

Operand Unit::sendInto(Scope::Handle& handle, const std::string& name, const ast::Expression& value, ast::Place at) {
    const auto* const from = std::get_if<ast::Name>(&value.what);
    const std::size_t count = from ? from->parts.size() : 0;
    const bool sends = count > 1 && from->parts.back().text == "send";
    const Callable called = sends ? callable(from->parts, count - 1, walk(from->parts, count), true) : Callable();
    if (!called.part) {
        if (sends) expression(value);  // says what is unknown
        error(value.at, "OPS149", "expected 'operation.send(...)' for the handle '" + name + "'");
    }
    const Operand call = sent(*called.part, *from, value.at);
    Source source = handle.source();
    if (handle.operation().get() != called.part) {
        const Source own = made(*from, value.at, *called.part, [&] { return called.part->produceHandle(); });
        // What was compiled before has the same variable, if it can: which operation was sent last shows at run time.
        if (!source || !source->hasTypeOf(*own)) source = own;
        handle.set(OperationInterfacePart::hold(called.part), source);
    }
    const Operand result = fromSource(source, at);
    store(result, call, "the handle");
    return result;
}

void Unit::failUnsent(const ast::Identifier& handle) {
    error(handle.at, "OPS148", "nothing was sent with the handle '" + handle.text + "' before this line");
}

void Unit::failRecursive(const std::string& function, ast::Place at) {
    error(at, "OPS151", "function '" + function + "' calls itself, directly or through another one");
}

Operand Unit::callFunction(const std::shared_ptr<const FunctionDefinition>& definition, const ast::Name& name,
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
    // Its own copy, because the next call writes another one.
    const Operand returned = fromSource(activation->result, at);
    if (returned.address)
        return computedBy(conversionAction(returned.kind, returned.kind), returned.address, nullptr, returned.kind, at);
    result = fromSource(activation->result->clone(), at);
    store(result, returned, "the result");
    result.computed = true;
    return result;
}

}  // namespace detail
}  // namespace scripting
}  // namespace RTT
