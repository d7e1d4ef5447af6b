// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <view/view.hpp>

#include <model/names.hpp>
#include <model/registration.hpp>
#include <view/interface_view.hpp>

namespace oroforge::view {

namespace {

using nlohmann::json;

/// Makes text fit a table cell: one line, and no bar that would end the cell.
std::string cell(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '|') result += '\\';
        const bool blank = c == '\n' || c == '\r' || c == '\t' || c == ' ';
        if (!blank) {
            result += c;
        } else if (!result.empty() && result.back() != ' ') {
            result += ' ';
        }
    }
    return result;
}

std::string code(const std::string& text) { return text.empty() ? "" : "`" + cell(text) + "`"; }

/// Returns text outside of tables: lines without their indentation.
std::string paragraph(const std::string& text) {
    std::string result;
    bool lineBegins = true;
    for (const char c : text) {
        if (lineBegins && (c == ' ' || c == '\t')) continue;
        lineBegins = c == '\n';
        result += c;
    }
    return result;
}

std::string rangeOf(const model::Value& value) {
    if (value.minimum && value.maximum) return value.minimum->text + " to " + value.maximum->text;
    if (value.minimum) return "from " + value.minimum->text;
    return value.maximum ? "up to " + value.maximum->text : "";
}

json portEntry(const model::Port& port) {
    std::string policy;
    if (port.policy) {
        policy = port.policy->type;
        if (port.policy->size) policy += " of " + port.policy->size->text;
        if (!port.policy->lock.empty()) policy += ", " + port.policy->lock;
    }
    const bool input = port.direction == model::Direction::In;
    return {{"name", code(port.name.value)},
            {"kind", port.event ? "event input"
                     : input    ? "input"
                                : "output"},
            {"type", code(port.type.value)},
            {"policy", cell(policy)},
            {"doc", cell(port.doc)}};
}

json valueEntry(const model::Value& value) {
    return {
        {"name", code(value.name.value)}, {"type", code(value.type.value)}, {"default", code(value.defaultValue.value)},
        {"unit", cell(value.unit)},       {"range", cell(rangeOf(value))},  {"doc", cell(value.doc)}};
}

json attributeEntry(const model::Attribute& attribute) {
    json entry = valueEntry(attribute);
    if (attribute.constant) entry["doc"] = cell(attribute.doc.empty() ? "constant" : "constant; " + attribute.doc);
    return entry;
}

json operationEntry(const model::Operation& operation) {
    std::string signature = model::returnsOf(operation) + " " + operation.name.value;
    json arguments = json::array();
    std::string list;
    for (const model::Argument& argument : operation.arguments) {
        list += (list.empty() ? "" : ", ") + argument.type.value + " " + argument.name.value;
        const std::string unit = argument.unit.empty() ? "" : " [" + argument.unit + "]";
        if (argument.doc.empty() && unit.empty()) continue;
        const std::string doc = cell(argument.doc);
        arguments.push_back({{"name", code(argument.name.value)},
                             {"doc", doc + (doc.empty() && !unit.empty() ? unit.substr(1) : unit)}});
    }
    return {{"signature", code(signature + "(" + list + ")")},
            {"thread", operation.thread == model::Thread::Own ? "the component's" : "the caller's"},
            {"doc", cell(operation.doc)},
            {"arguments", arguments}};
}

template <class Items, class MakeEntry>
void put(json& view, const char* key, const Items& items, MakeEntry makeEntry) {
    view[key] = json::array();
    for (const auto& item : items) view[key].push_back(makeEntry(item));
    view[std::string("has_") + key] = !view[key].empty();
}

/// Makes a section for the interface itself, and for each service in it.
json sections(const model::Interface& top, const std::string& title, const std::string& doc) {
    json list = json::array();
    const auto add = [&](const model::Interface& interface, const std::string& heading, const std::string& text) {
        json view{{"heading", heading}, {"doc", orNull(paragraph(text))}};
        put(view, "ports", interface.ports, portEntry);
        put(view, "properties", interface.properties, valueEntry);
        put(view, "attributes", interface.attributes, attributeEntry);
        put(view, "operations", interface.operations, operationEntry);
        list.push_back(view);
    };
    add(top, "## " + title, doc);
    model::eachInterface(top, [&](const model::Interface& interface, const model::ServicePath& path) {
        for (const model::Service& service : interface.services)
            add(service, "### Service " + model::fullName(path, service.name.value), service.doc);
    });
    return list;
}

void append(json& list, const json& more) {
    for (const json& item : more) list.push_back(item);
}

json requirementEntry(const model::Requirement& required) {
    json view{{"name", code(required.name.value)}, {"doc", cell(required.doc)}};
    put(view, "operations", required.operations, operationEntry);
    return view;
}

}  // namespace

json referenceView(const model::Package& package, const std::string& manifest) {
    json view{
        {"name", package.name.value}, {"manifest", manifest}, {"description", orNull(paragraph(package.description))}};
    view["sections"] = json::array();
    for (const model::Component& component : package.components) {
        json parts = sections(component, "Component " + component.className.value, component.doc);
        put(parts.front(), "required", component.required, requirementEntry);
        append(view["sections"], parts);
    }
    for (const model::ServicePlugin& service : package.services) {
        append(view["sections"], sections(service, "Service " + service.name.value, service.doc));
    }
    return view;
}

}  // namespace oroforge::view
