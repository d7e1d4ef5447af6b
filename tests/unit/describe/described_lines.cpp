// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <algorithm>

#include <model/cpp_type.hpp>

#include "interface_lines.hpp"

namespace oroforge::test {

namespace {

std::string valueOf(const model::Text& value, const std::string& type) {
    const auto kind = model::classify(type);
    if (kind == model::TypeClass::Other) return "?";
    if (value.given()) return value.value;
    if (kind == model::TypeClass::Boolean) return "false";
    return model::isNumber(kind) ? "0" : "";
}

std::string signatureOf(const model::Operation& operation) {
    std::string text = operation.returns.given() ? commonSpelling(operation.returns.value) : "void";
    text += " (";
    for (const auto& argument : operation.arguments)
        text += (text.back() == '(' ? "" : ", ") + commonSpelling(argument.type.value);
    return text + ")";
}

/// As generated code has it.
std::string docOf(const std::string& doc, const std::string& unit) {
    return unit.empty() ? doc : doc + (doc.empty() ? "[" : " [") + unit + "]";
}

void addInterface(const model::Interface& interface, const std::string& path, Lines& lines) {
    for (const auto& port : interface.ports) {
        const char* direction = port.direction == model::Direction::In ? "in" : "out";
        lines.push_back(path + "port " + port.name.value + ": " + direction + " " + commonSpelling(port.type.value) +
                        (port.event ? ", event" : "") + " // " + port.doc);
        if (!port.policy || port.policy->type == "data") continue;  // as it is without one
        lines.push_back(path + "policy " + port.name.value + ": " + port.policy->type + " " +
                        (port.policy->size ? port.policy->size->text : "0"));
    }
    for (const auto& property : interface.properties)
        lines.push_back(path + "property " + property.name.value + ": " + commonSpelling(property.type.value) + " = " +
                        valueOf(property.defaultValue, property.type.value) + " // " +
                        docOf(property.doc, property.unit));
    for (const auto& attribute : interface.attributes)
        lines.push_back(path + (attribute.constant ? "constant " : "attribute ") + attribute.name.value + ": " +
                        commonSpelling(attribute.type.value) + " = " +
                        valueOf(attribute.defaultValue, attribute.type.value));
    Lines operations;
    for (const auto& operation : interface.operations) {
        std::string line = path + "operation " + operation.name.value + ": " + signatureOf(operation) +
                           (operation.thread == model::Thread::Own ? ", own thread" : "") + " // " + operation.doc;
        for (const auto& argument : operation.arguments)
            line += "; " + argument.name.value + ": " + docOf(argument.doc, argument.unit);
        operations.push_back(line);
    }
    std::sort(operations.begin(), operations.end());
    lines.insert(lines.end(), operations.begin(), operations.end());
    std::vector<const model::Service*> services;
    for (const auto& service : interface.services) services.push_back(&service);
    std::sort(services.begin(), services.end(),
              [](const auto* a, const auto* b) { return a->name.value < b->name.value; });
    for (const auto* service : services) {
        lines.push_back(path + "service " + service->name.value + " // " + service->doc);
        addInterface(*service, path + service->name.value + ".", lines);
    }
}

std::string activityOf(const std::optional<model::Activity>& activity) {
    if (!activity) return "activity thread 0";
    const char* kind = activity->kind == model::ActivityKind::Sequential ? "sequential"
                       : activity->kind == model::ActivityKind::Slave    ? "slave"
                                                                         : "thread";
    return std::string("activity ") + kind + " " + (activity->period ? activity->period->text : "0");
}

}  // namespace

Lines linesOf(const model::Component& component) {
    Lines lines = {component.initial == model::InitialState::Stopped ? "Stopped" : "PreOperational",
                   activityOf(component.activity)};
    addInterface(component, "", lines);
    Lines callers;
    for (const auto& service : component.required) {
        for (const auto& operation : service.operations)
            callers.push_back("requires " + service.name.value + "." + operation.name.value + ": " +
                              signatureOf(operation));
    }
    std::sort(callers.begin(), callers.end());
    lines.insert(lines.end(), callers.begin(), callers.end());
    return lines;
}

Lines linesOf(const model::ServicePlugin& service) {
    Lines lines = {"service " + service.name.value + " // " + service.doc};
    addInterface(service, "", lines);
    return lines;
}

}  // namespace oroforge::test
