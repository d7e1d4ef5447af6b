// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "interface_json.hpp"

#include "fields.hpp"

#include <console/table.hpp>
#include <console/type_name.hpp>
#include <rtt/Attribute.hpp>
#include <rtt/OperationInterfacePart.hpp>
#include <rtt/base/OperationCallerInterface.hpp>
#include <rtt/base/PropertyBase.hpp>
#include <rtt/internal/calls/operation_signature.hpp>
#include <rtt/internal/calls/standard_operations.hpp>

#include <boost/core/demangle.hpp>

#include <algorithm>
#include <typeinfo>

namespace OCL::live {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestText = 4096;  // of one value among others

json argumentJson(const RTT::internal::OperationSignature::Value& argument) {
    json made = {
        {"name", argument.name}, {"type", console::dotted(argument.plainText())}, {"doc", argument.description}};
    if (argument.isOutput()) made["output"] = true;
    return made;
}

}  // namespace

const char* stateOf(RTT::TaskContext& component) {
    // For a proxy the functions ask its process, so the answer may be one of a broken connection.
    switch (component.getTaskState()) {
        case RTT::TaskContext::Init: return "Init";
        case RTT::TaskContext::PreOperational: return "PreOperational";
        case RTT::TaskContext::FatalError: return "FatalError";
        case RTT::TaskContext::Exception: return "Exception";
        case RTT::TaskContext::Stopped: return "Stopped";
        case RTT::TaskContext::Running: return "Running";
        case RTT::TaskContext::RunTimeError: return "RunTimeError";
    }
    return "unknown";
}

std::string classOf(RTT::TaskContext& component) { return boost::core::demangle(typeid(component).name()); }

json propertyHead(const RTT::base::PropertyBase& property) {
    std::string doc = property.getDescription();
    const std::string unit = unitOf(doc);
    const Source value = property.getDataSource();
    return {{"name", property.getName()},
            {"type", typeOf(value)},
            {"unit", unit},
            {"doc", doc},
            {"writable", value && value->isAssignable()}};
}

json attributeHead(const RTT::base::AttributeBase& attribute) {
    const Source value = attribute.getDataSource();
    return {{"name", attribute.getName()},
            {"type", typeOf(value)},
            {"unit", ""},
            {"doc", ""},
            {"writable", value && value->isAssignable()}};
}

json operationJson(const RTT::OperationInterfacePart& part) {
    const auto signature = part.signature();
    json arguments = json::array();
    for (const auto& argument : signature.arguments) arguments.push_back(argumentJson(argument));
    const auto local = part.getLocalOperation();
    const auto* const caller = dynamic_cast<const RTT::base::OperationCallerInterface*>(local.get());
    return {{"name", part.getName()},
            {"result", console::dotted(signature.result.plainText())},
            {"arguments", std::move(arguments)},
            {"doc", part.description()},
            {"thread", !local || (caller && caller->getThread() == RTT::OwnThread) ? "own" : "client"},
            {"usual", RTT::internal::standardOperation(part.getName()) ? true : false}};
}

json portJson(const RTT::base::PortInterface& port, const KnownPorts& known, std::size_t most) {
    json connections = json::array();
    for (const auto& connection : port.getManager()->getConnections())
        connections.push_back(known.partnerOf(connection));
    const Source last = known.lastSample(port);
    return {{"name", port.getName()},
            {"type", typeOfPort(port)},
            {"direction", port.asInput() ? "in" : "out"},
            {"connected", port.connected()},
            {"connections", std::move(connections)},
            {"doc", OCL::console::oneLine(port.getDescription())},
            {"text", last ? textOf(last, most) : ""}};
}

void addValue(json& to, const Source& value, std::size_t& left) {
    const std::size_t most = std::min(left, kLongestText);
    const std::string text = textOf(value, std::string::npos);
    bool wasCut = text.size() > most;
    to["text"] = cut(text, most);
    json made = jsonOf(value, most, wasCut);
    to["value"] = std::move(made);
    if (wasCut) to["cut"] = true;
    left -= std::min(left, std::min(text.size(), most));
}

}  // namespace OCL::live
