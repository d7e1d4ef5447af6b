// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <view/interface_view.hpp>

#include <model/cpp_type.hpp>
#include <model/doc_text.hpp>
#include <model/literal.hpp>
#include <model/names.hpp>
#include <model/registration.hpp>

namespace oroforge::view {

namespace {

using nlohmann::json;

json docLiteral(const std::string& doc) { return doc.empty() ? json(nullptr) : json(model::stringLiteral(doc)); }

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

/// Keys of everything in an interface: its name, its service as seen from the component, and its name in C++.
json placed(const model::Text& name, const model::ServicePath& path) {
    const std::string access = model::accessTo(path);
    const std::string method = model::methodName(path, name.value);
    return {{"name", name.value},
            {"path", access},
            {"servicePath", path.empty() ? "provides()->" : access},
            {"fullName", model::fullName(path, name.value)},
            {"method", method},
            {"member", model::memberName(method)}};
}

json portView(const model::Port& port, const model::ServicePath& path) {
    json view = placed(port.name, path);
    view["type"] = port.type.value;
    view["portClass"] = model::portClass(port);
    view["input"] = port.direction == model::Direction::In;
    view["add"] = model::registrationOf(port);
    view["doc"] = docLiteral(model::oneLine(port.doc));
    view["comment"] = orNull(model::oneLine(port.doc));
    view["policy"] = port.policy ? policyView(*port.policy) : json(nullptr);
    return view;
}

/// Makes a condition per limit, but none that is always true: compilers warn about those.
json limitsOf(const model::Value& property, const std::string& member) {
    const model::TypeClass kind = model::classify(property.type.value);
    json list = json::array();
    const auto add = [&](const char* comparison, const char* words, const model::Number& limit) {
        list.push_back(
            {{"condition", member + " " + comparison + " " + model::valueLiteral(limit.text, property.type.value)},
             {"expected", model::stringLiteral(", expected " + std::string(words) + " " + limit.text)}});
    };
    const bool alwaysTrue = kind == model::TypeClass::Unsigned && property.minimum && property.minimum->value <= 0;
    if (property.minimum && !alwaysTrue) add(">=", "at least", *property.minimum);
    if (property.maximum) add("<=", "at most", *property.maximum);
    return list;
}

json valueView(const model::Value& value, const model::ServicePath& path) {
    json view = placed(value.name, path);
    view["type"] = value.type.value;
    view["init"] = model::initialiser(value.defaultValue, value.type.value);
    const std::string doc = model::docWithUnit(value.doc, value.unit);
    view["doc"] = docLiteral(doc);
    view["comment"] = orNull(doc);
    view["unit"] = orNull(value.unit.empty() ? "" : model::stringLiteral(" " + value.unit));
    view["limits"] = limitsOf(value, view["member"]);
    return view;
}

json propertyView(const model::Property& property, const model::ServicePath& path) {
    json view = valueView(property, path);
    const model::TypeClass kind = model::classify(property.type.value);
    const bool comparable = property.defaultValue.given() && kind != model::TypeClass::Other;
    view["defaultLiteral"] =
        comparable ? json(model::valueLiteral(property.defaultValue.value, property.type.value)) : json(nullptr);
    return view;
}

json attributeView(const model::Attribute& attribute, const model::ServicePath& path) {
    json view = valueView(attribute, path);
    view["add"] = model::registrationOf(attribute);
    view["qualifier"] = model::qualifierOf(attribute);
    return view;
}

json operationView(const model::Operation& operation, const model::ServicePath& path) {
    json view = placed(operation.name, path);
    const std::string returns = model::returnsOf(operation);
    view["returns"] = returns;
    view["thread"] = model::threadOf(operation);
    view["doc"] = docLiteral(model::oneLine(operation.doc));
    view["comment"] = model::commentLines(operation.doc);
    view["result"] = orNull(model::firstResult(operation));
    view["args"] = json::array();
    std::string signature, parameters, unused;
    for (const model::Argument& argument : operation.arguments) {
        const std::string separator = signature.empty() ? "" : ", ", type = argument.type.value;
        signature += separator + type;
        parameters += separator + type + " " + argument.name.value;
        unused += separator + type + " /*" + argument.name.value + "*/";
        view["args"].push_back({{"name", argument.name.value},
                                {"type", type},
                                {"doc", model::stringLiteral(model::docWithUnit(argument.doc, argument.unit))}});
    }
    view["parameters"] = parameters;
    view["unusedParameters"] = unused;
    view["signature"] = returns + "(" + signature + ")";
    return view;
}

json requirementView(const model::Requirement& required) {
    json view{{"name", required.name.value}, {"comment", orNull(model::oneLine(required.doc))}};
    view["callers"] = json::array();
    for (const model::Operation& operation : required.operations) {
        json caller = operationView(operation, {required.name.value});
        caller["service"] = required.name.value;
        caller["comment"] = orNull(model::oneLine(operation.doc));
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
    view["doc"] = docLiteral(model::oneLine(service.doc));
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
