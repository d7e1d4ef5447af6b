// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The verb `call`.
#include "failure.hpp"
#include "fields.hpp"
#include "permissions.hpp"
#include "values.hpp"
#include "verbs.hpp"

#include <rtt/Logger.hpp>
#include <rtt/OperationInterfacePart.hpp>
#include <rtt/base/OperationCallerInterface.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/OperationCallerC.hpp>
#include <rtt/internal/calls/operation_signature.hpp>
#include <rtt/types/Types.hpp>

#include <exception>
#include <memory>
#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;
using RTT::OperationInterfacePart;
using RTT::internal::OperationCallerC;
using RTT::internal::OperationSignature;

constexpr std::size_t kMostText = 64 * 1024, kMostValue = 1024 * 1024, kLogged = 200;

/** A call with all that it uses, so that the component may execute it when nobody waits any more. */
struct Call {
    std::string path;
    OperationSignature signature;
    OperationInterfacePart::Args arguments;
    Source result;  ///< null if there is none, or its type is unknown
    OperationCallerC caller;
    Gate gate;   ///< of the component whose thread executes it; null for this thread
    Gate owner;  ///< of the component; null for an operation of the process
    std::string component;

    void execute() {
        if (!caller.call()) throw Failure(kFailed, "operation '" + path + "' was not executed; the log says why");
    }
};

/** The operation at the end of the path; those of ports, too. */
const OperationInterfacePart* operationIn(const Found& at) {
    if (at.rest.size() == 1) return at.service->getPart(at.rest[0]);
    if (at.rest.size() != 2 || !at.service->getPort(at.rest[0])) return nullptr;
    const RTT::Service::shared_ptr object = at.service->getService(at.rest[0]);
    return object ? object->getPart(at.rest[1]) : nullptr;
}

void assignArgument(const Source& to, const json& from, const std::string& name) {
    const bool takesText = RTT::internal::DataSource<std::string>::narrow(to.get());
    if (!from.is_string() || takesText) return assign(to, from, name);
    try {
        assign(to, from.get_ref<const std::string&>(), name);
    } catch (const Failure& failure) {
        try {
            assign(to, from, name);  // as a letter, which may be a blank
        } catch (const Failure&) {
            throw failure;
        }
    }
}

std::string nameOf(const OperationSignature& signature, std::size_t index) {
    const std::string& name = signature.arguments[index].name;
    return "argument " + std::to_string(index + 1) + (name.empty() ? "" : " ('" + name + "')");
}

void addArguments(Call& call, const json& from) {
    const OperationSignature& signature = call.signature;
    if (from.size() != signature.arguments.size())
        throw Failure(kWrongValue, "operation '" + call.path + "' has " + std::to_string(signature.arguments.size()) +
                                       (signature.arguments.size() == 1 ? " argument" : " arguments") + ", found " +
                                       std::to_string(from.size()));
    for (std::size_t i = 0; i != from.size(); ++i) {
        const auto* const type = signature.arguments[i].type;
        const Source made = type ? type->buildValue() : nullptr;
        if (!made)
            throw Failure(kNoForm, nameOf(signature, i) + " of operation '" + call.path + "' has the type " +
                                       signature.arguments[i].typeName + ", of which no value can be made");
        assignArgument(made, from[i], nameOf(signature, i));
        call.arguments.push_back(made);
        call.caller.arg(made);
    }
}

/** The owner, if its thread executes the operation; a remote one is asked by this thread. */
bool isOfOwnThread(const OperationInterfacePart& part) {
    const auto local = part.getLocalOperation();
    const auto* const caller = dynamic_cast<const RTT::base::OperationCallerInterface*>(local.get());
    return caller && caller->getThread() == RTT::OwnThread && caller->getOwner();
}

std::shared_ptr<Call> prepare(const Found& at, const json& arguments) {
    const OperationInterfacePart* const part = operationIn(at);
    if (!part) unknown(at, "operation");
    const auto call = std::make_shared<Call>();
    call->path = at.pathWith(at.rest.size() == 1 ? at.rest[0] : at.rest[0] + "." + at.rest[1]);
    call->signature = part->signature();
    call->component = at.componentName();
    call->caller = OperationCallerC(part, part->getName(), RTT::internal::GlobalEngine::Instance());
    call->owner = at.gate;
    if (isOfOwnThread(*part)) call->gate = at.gate;
    addArguments(*call, arguments);
    const auto& result = call->signature.result;
    if (!result.isVoid() && result.type && result.type != RTT::types::Types()->unknownType())
        call->result = result.type->buildValue();
    if (call->result) call->caller.ret(call->result);
    call->caller.check();
    return call;
}

json valueJson(const Source& value) {
    const std::string text = textOf(value, std::string::npos);
    bool wasCut = text.size() > kMostText;
    json made = {{"type", typeOf(value)}, {"text", cut(text, kMostText)}};
    json inner = jsonOf(value, kMostValue, wasCut);
    made["value"] = std::move(inner);
    if (wasCut) made["cut"] = true;
    return made;
}

json answerOf(const Call& call) {
    const auto& signature = call.signature;
    json made = call.result
                    ? valueJson(call.result)
                    : json{{"type", signature.result.isVoid() ? "void" : "unknown_t"}, {"text", ""}, {"value", {}}};
    json outputs = json::array();
    for (std::size_t i = 0; i != call.arguments.size(); ++i) {
        if (!signature.arguments[i].isOutput()) continue;
        json each = valueJson(call.arguments[i]);
        each["name"] = signature.arguments[i].name;
        each["index"] = i;
        outputs.push_back(std::move(each));
    }
    if (!outputs.empty()) made["arguments"] = std::move(outputs);
    return made;
}

std::string argumentsText(const Call& call) {
    std::string text;
    for (const Source& each : call.arguments) text += (text.empty() ? "" : ", ") + textOf(each, kLogged);
    return cut(text, kLogged);
}

}  // namespace

json call(const Asked& asked) {
    const json none = json::array();
    const json& arguments = asked.request.contains("arguments") ? asked.request["arguments"] : none;
    if (!arguments.is_array())
        throw Failure(kMalformed, std::string("field 'arguments' is ") + kindOf(arguments) + ", expected an array");
    std::shared_ptr<Call> call;
    const auto note = [&] {
        RTT::log(RTT::Info) << asked.caller.name << " calls " << call->path << "(" << argumentsText(*call) << ")"
                            << RTT::endlog();
    };
    try {
        {
            Visits visits;
            const Found at = find(asked.root, visits, textField(asked.request, "path"));
            if (at.rest.empty())
                throw Failure(kUnknownName, "'" + textField(asked.request, "path") + "' is a " +
                                                (at.isComponent ? "component" : "service") + ", expected an operation");
            const std::string why = whyNotCalled(asked, at);
            if (!why.empty()) throw Failure(kNotAllowed, why);
            call = prepare(at, arguments);
            note();
            // The component must exist while its code runs in this thread.
            if (!call->gate) call->execute();
        }
        if (call->gate) inThreadOf(call->gate, call->component, asked.limit, [call] { call->execute(); });
    } catch (const Failure&) {
        throw;
    } catch (const std::exception& thrown) {
        if (call && call->owner && call->owner->closed())
            throw Failure(kGone, "component '" + call->component + "' was destroyed");
        throw Failure(kFailed, call ? "operation '" + call->path + "' threw: " + thrown.what() : thrown.what());
    }
    return answerOf(*call);
}

}  // namespace OCL::live
