// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <view/interface_view.hpp>

#include <model/cpp_type.hpp>
#include <model/interfaces.hpp>
#include <view/cpp_text.hpp>

namespace oroforge::view {

namespace {

using nlohmann::json;

/// Ends every item but the last with a comma.
json separated(json list) {
    for (std::size_t i = 0; i < list.size(); ++i) list[i]["comma"] = i + 1 < list.size() ? ", " : "";
    return list;
}

/// What a display shows: the documentation with the unit behind it.
std::string docWithUnit(const std::string& doc, const std::string& unit) {
    if (unit.empty()) return oneLine(doc);
    return doc.empty() ? "[" + unit + "]" : oneLine(doc) + " [" + unit + "]";
}

json docLiteral(const std::string& doc) { return doc.empty() ? json(nullptr) : json(stringLiteral(doc)); }

json policyView(const model::Policy& policy) {
    json view;
    const std::string size = policy.size ? policy.size->text : "";
    view["make"] = policy.type == "data"     ? std::string("RTT::ConnPolicy::data(")
                   : policy.type == "buffer" ? "RTT::ConnPolicy::buffer(" + size + ", "
                                             : "RTT::ConnPolicy::circularBuffer(" + size + ", ";
    view["lock"] = policy.lock == "locked" ? "LOCKED" : policy.lock == "unsync" ? "UNSYNC" : "LOCK_FREE";
    view["init"] = policy.init ? "true" : "false";
    view["pull"] = policy.pull ? "true" : "false";
    return view;
}

/// What all that stands in an interface has: its name there, where that is from the component, and its name in C++.
json placed(const model::Text& name, const model::ServicePath& path) {
    std::string access;
    std::string scope;
    for (const std::string& service : path) {
        access += "provides(\"" + service + "\")->";
        scope += service + ".";
    }
    return {{"name", name.value},
            {"path", access},
            {"servicePath", path.empty() ? "provides()->" : access},
            {"fullName", scope + name.value},
            {"method", model::memberName(path, name.value)},
            {"member", model::memberName(path, name.value) + "_"}};
}

json portView(const model::Port& port, const model::ServicePath& path) {
    const bool input = port.direction == model::Direction::In;
    json view = placed(port.name, path);
    view["type"] = port.type.value;
    view["portClass"] = input ? "InputPort" : "OutputPort";
    view["input"] = input;
    view["add"] = port.event ? "addEventPort" : "addPort";
    view["doc"] = docLiteral(oneLine(port.doc));
    view["comment"] = orNull(oneLine(port.doc));
    view["policy"] = port.policy ? policyView(*port.policy) : json(nullptr);
    return view;
}

/// One condition per limit. Nothing that is always true: compilers warn about it.
template <class Value>
json limitsOf(const Value& property, const std::string& member) {
    const model::TypeClass kind = model::classify(property.type.value);
    json list = json::array();
    const auto add = [&](const char* comparison, const char* words, const model::Number& limit) {
        list.push_back({{"condition", member + " " + comparison + " " + valueLiteral(limit.text, property.type.value)},
                        {"expected", stringLiteral(", expected " + std::string(words) + " " + limit.text)}});
    };
    const bool alwaysTrue = kind == model::TypeClass::Unsigned && property.minimum && property.minimum->value <= 0;
    if (property.minimum && !alwaysTrue) add(">=", "at least", *property.minimum);
    if (property.maximum) add("<=", "at most", *property.maximum);
    return list;
}

std::string initialiser(const model::Text& value, const std::string& type) {
    return value.given() ? " = " + valueLiteral(value.value, type) : "{}";
}

/// Of a property or an attribute.
template <class Value>
json valueView(const Value& value, const model::ServicePath& path) {
    json view = placed(value.name, path);
    view["type"] = value.type.value;
    view["init"] = initialiser(value.defaultValue, value.type.value);
    const std::string doc = docWithUnit(value.doc, value.unit);
    view["doc"] = docLiteral(doc);
    view["comment"] = orNull(doc);
    view["unit"] = orNull(value.unit.empty() ? "" : stringLiteral(" " + value.unit));
    view["limits"] = limitsOf(value, view["member"]);
    return view;
}

json propertyView(const model::Property& property, const model::ServicePath& path) {
    json view = valueView(property, path);
    const model::TypeClass kind = model::classify(property.type.value);
    const bool comparable = property.defaultValue.given() && kind != model::TypeClass::Other;
    view["defaultLiteral"] =
        comparable ? json(valueLiteral(property.defaultValue.value, property.type.value)) : json(nullptr);
    return view;
}

json attributeView(const model::Attribute& attribute, const model::ServicePath& path) {
    json view = valueView(attribute, path);
    view["add"] = attribute.constant ? "addConstant" : "addAttribute";
    view["qualifier"] = attribute.constant ? "const " : "";
    return view;
}

json operationView(const model::Operation& operation, const model::ServicePath& path) {
    json view = placed(operation.name, path);
    const std::string returns = operation.returns.given() ? operation.returns.value : "void";
    view["returns"] = returns;
    view["thread"] = operation.thread == model::Thread::Own ? "OwnThread" : "ClientThread";
    view["doc"] = docLiteral(oneLine(operation.doc));
    view["comment"] = commentLines(operation.doc);
    // Something to return from a method that does nothing yet.
    view["result"] = returns == "void" ? json(nullptr) : json(returns == "bool" ? "true" : "{}");
    view["args"] = json::array();
    std::string signature;
    for (const model::Argument& argument : operation.arguments) {
        signature += (signature.empty() ? "" : ", ") + argument.type.value;
        view["args"].push_back({{"name", argument.name.value},
                                {"type", argument.type.value},
                                {"doc", stringLiteral(docWithUnit(argument.doc, argument.unit))}});
    }
    view["args"] = separated(view["args"]);
    view["signature"] = returns + "(" + signature + ")";
    return view;
}

json requirementView(const model::Requirement& required) {
    json view{{"name", required.name.value}, {"comment", orNull(oneLine(required.doc))}};
    view["callers"] = json::array();
    for (const model::Operation& operation : required.operations) {
        json caller = operationView(operation, {required.name.value});
        caller["service"] = required.name.value;
        caller["comment"] = orNull(oneLine(operation.doc));
        view["callers"].push_back(caller);
    }
    return view;
}

template <class Items, class MakeView>
void append(json& list, const Items& items, const model::ServicePath& path, MakeView makeView) {
    for (const auto& item : items) list.push_back(makeView(item, path));
}

json providedView(const model::Service& service, const model::ServicePath& path) {
    json view = placed(service.name, path);
    view["doc"] = docLiteral(oneLine(service.doc));
    return view;
}

}  // namespace

json orNull(const std::string& text) { return text.empty() ? json(nullptr) : json(text); }

void putInterface(json& view, const model::Interface& top) {
    for (const char* group : {"ports", "properties", "attributes", "operations", "provided"}) {
        view[group] = json::array();
    }
    model::eachInterface(top, [&](const model::Interface& interface, const model::ServicePath& path) {
        append(view["ports"], interface.ports, path, portView);
        append(view["properties"], interface.properties, path, propertyView);
        append(view["attributes"], interface.attributes, path, attributeView);
        append(view["operations"], interface.operations, path, operationView);
        append(view["provided"], interface.services, path, providedView);
    });
    bool hasRanges = false;
    for (const char* group : {"properties", "attributes"}) {
        for (const json& value : view[group]) hasRanges = hasRanges || !value["limits"].empty();
    }
    view["hasRanges"] = hasRanges;
    for (const char* group : {"ports", "properties", "attributes", "operations"}) {
        view[std::string("has_") + group] = !view[group].empty();
    }
    view["hasMembers"] = view["has_ports"] || view["has_properties"] || view["has_attributes"];
}

json requirementViews(const std::vector<model::Requirement>& required) {
    json list = json::array();
    for (const model::Requirement& service : required) list.push_back(requirementView(service));
    return list;
}

std::vector<std::string> typesIn(const model::Interface& top, const std::vector<model::Requirement>& required) {
    std::vector<std::string> types;
    const auto addOperation = [&](const model::Operation& operation) {
        types.push_back(operation.returns.value);
        for (const auto& argument : operation.arguments) types.push_back(argument.type.value);
    };
    model::eachInterface(top, [&](const model::Interface& interface, const model::ServicePath&) {
        for (const auto& port : interface.ports) types.push_back(port.type.value);
        for (const auto& property : interface.properties) types.push_back(property.type.value);
        for (const auto& attribute : interface.attributes) types.push_back(attribute.type.value);
        for (const auto& operation : interface.operations) addOperation(operation);
    });
    for (const auto& service : required) {
        for (const auto& operation : service.operations) addOperation(operation);
    }
    return types;
}

}  // namespace oroforge::view
