// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <view/view.hpp>

#include <emit/banner.hpp>
#include <model/cpp_type.hpp>
#include <view/cpp_text.hpp>

namespace oroforge::view {

namespace {

using nlohmann::json;

const char* const kTool = "orocreate-pkg";

json orNull(const std::string& text) { return text.empty() ? json(nullptr) : json(text); }

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

json portView(const model::Port& port) {
    const bool input = port.direction == model::Direction::In;
    json view;
    view["name"] = port.name.value;
    view["type"] = port.type.value;
    view["member"] = port.name.value + "_";
    view["portClass"] = input ? "InputPort" : "OutputPort";
    view["input"] = input;
    view["add"] = port.event ? "addEventPort" : "addPort";
    view["doc"] = docLiteral(oneLine(port.doc));
    view["comment"] = orNull(oneLine(port.doc));
    view["policy"] = port.policy ? policyView(*port.policy) : json(nullptr);
    return view;
}

/// One condition per limit. Nothing that is always true: compilers warn about it.
json limitsOf(const model::Property& property) {
    const model::TypeClass kind = model::classify(property.type.value);
    json list = json::array();
    const auto add = [&](const char* comparison, const char* words, const model::Number& limit) {
        list.push_back({{"condition",
                         property.name.value + "_ " + comparison + " " + valueLiteral(limit.text, property.type.value)},
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

json propertyView(const model::Property& property) {
    json view;
    const model::TypeClass kind = model::classify(property.type.value);
    view["name"] = property.name.value;
    view["type"] = property.type.value;
    view["member"] = property.name.value + "_";
    view["init"] = initialiser(property.defaultValue, property.type.value);
    const std::string doc = docWithUnit(property.doc, property.unit);
    view["doc"] = docLiteral(doc);
    view["comment"] = orNull(doc);
    view["unit"] = orNull(property.unit.empty() ? "" : stringLiteral(" " + property.unit));
    view["limits"] = limitsOf(property);
    const bool comparable = property.defaultValue.given() && kind != model::TypeClass::Other;
    view["defaultLiteral"] =
        comparable ? json(valueLiteral(property.defaultValue.value, property.type.value)) : json(nullptr);
    return view;
}

json attributeView(const model::Attribute& attribute) {
    json view;
    view["name"] = attribute.name.value;
    view["type"] = attribute.type.value;
    view["member"] = attribute.name.value + "_";
    view["init"] = initialiser(attribute.defaultValue, attribute.type.value);
    view["comment"] = orNull(oneLine(attribute.doc));
    return view;
}

json operationView(const model::Operation& operation) {
    json view;
    const std::string returns = operation.returns.given() ? operation.returns.value : "void";
    view["name"] = operation.name.value;
    view["returns"] = returns;
    view["thread"] = operation.thread == model::Thread::Own ? "OwnThread" : "ClientThread";
    view["doc"] = docLiteral(oneLine(operation.doc));
    view["comment"] = commentLines(operation.doc);
    // Something to return from a method that does nothing yet.
    view["result"] = returns == "void" ? json(nullptr) : json(returns == "bool" ? "true" : "{}");
    view["args"] = json::array();
    for (const model::Argument& argument : operation.arguments) {
        view["args"].push_back({{"name", argument.name.value},
                                {"type", argument.type.value},
                                {"doc", stringLiteral(docWithUnit(argument.doc, argument.unit))}});
    }
    view["args"] = separated(view["args"]);
    return view;
}

json serviceView(const model::ServiceUse& service) {
    return {{"name", service.name.value},
            {"doc", docLiteral(oneLine(service.doc))},
            {"comment", orNull(oneLine(service.doc))}};
}

json activityView(const model::Activity& activity) {
    // As the constructors of RTT::Activity have it: who asks for a priority asks for the scheduler that has some.
    const char* usual = activity.priority && activity.priority->value > 0 ? "ORO_SCHED_RT" : "ORO_SCHED_OTHER";
    const std::string scheduler = activity.scheduler.given() ? activity.scheduler.value : usual;
    const std::string priority = activity.priority ? activity.priority->text : "RTT::os::LowestPriority";
    const std::string period = valueLiteral(activity.period ? activity.period->text : "0", "double");
    switch (activity.kind) {
        case model::ActivityKind::Sequential:
            return {{"header", "rtt/extras/SequentialActivity.hpp"}, {"make", "RTT::extras::SequentialActivity()"}};
        case model::ActivityKind::Slave:
            return {{"header", "rtt/extras/SlaveActivity.hpp"}, {"make", "RTT::extras::SlaveActivity(" + period + ")"}};
        case model::ActivityKind::Periodic:
        case model::ActivityKind::NonPeriodic: break;
    }
    return {{"header", "rtt/Activity.hpp"},
            {"make", "RTT::Activity(" + scheduler + ", " + priority + ", " + period + ", nullptr, name)"}};
}

std::vector<std::string> allTypes(const model::Component& component) {
    std::vector<std::string> types{"std::string"};
    for (const auto& port : component.ports) types.push_back(port.type.value);
    for (const auto& property : component.properties) types.push_back(property.type.value);
    for (const auto& attribute : component.attributes) types.push_back(attribute.type.value);
    for (const auto& operation : component.operations) {
        types.push_back(operation.returns.value);
        for (const auto& argument : operation.arguments) types.push_back(argument.type.value);
    }
    return types;
}

template <class Items, class MakeView>
json listOf(const Items& items, MakeView makeView) {
    json list = json::array();
    for (const auto& item : items) list.push_back(makeView(item));
    return list;
}

json servicesOf(const model::Component& component, model::ServiceRole role) {
    json list = json::array();
    for (const auto& service : component.services) {
        if (service.role == role) list.push_back(serviceView(service));
    }
    return list;
}

json hooksOf(const model::Hooks& hooks) {
    return {{"configure", hooks.configure}, {"start", hooks.start}, {"update", hooks.update},      {"stop", hooks.stop},
            {"cleanup", hooks.cleanup},     {"error", hooks.error}, {"exception", hooks.exception}};
}

}  // namespace

json componentView(const model::Package& package, const model::Component& component, const std::string& manifest) {
    const std::string qualified = component.className.value;
    const std::string space = namespaceOf(qualified);
    json view;
    view["banner"] = emit::banner(kTool, manifest);
    view["versionGuard"] = emit::versionGuard(kTool);
    view["package"] = package.name.value;
    view["manifest"] = manifest;
    view["class"] = lastName(qualified);
    view["qualified"] = qualified;
    view["namespace"] = orNull(space);
    view["guard"] = guardName(package.name.value + "_" + lastName(qualified));
    view["doc"] = commentLines(component.doc);
    view["stdHeaders"] = standardHeaders(allTypes(component));
    view["headers"] = listOf(package.typekitHeaders,
                             [&](const auto& header) { return includeName(header.value, package.name.value); });
    view["hasHeaders"] = !package.typekitHeaders.empty();
    view["initial"] = component.initial == model::InitialState::Stopped ? "Stopped" : "PreOperational";
    view["activity"] = component.activity ? activityView(*component.activity) : json(nullptr);
    view["ports"] = listOf(component.ports, portView);
    view["properties"] = listOf(component.properties, propertyView);
    view["attributes"] = listOf(component.attributes, attributeView);
    view["operations"] = listOf(component.operations, operationView);
    view["required"] = servicesOf(component, model::ServiceRole::Required);
    view["provided"] = servicesOf(component, model::ServiceRole::Provided);
    view["hooks"] = hooksOf(component.hooks);
    for (const json& wanted : view["hooks"]) view["hasHooks"] = view.value("hasHooks", false) || wanted.get<bool>();
    bool hasRanges = false;
    for (const json& property : view["properties"]) hasRanges = hasRanges || !property["limits"].empty();
    view["hasRanges"] = hasRanges;
    for (const char* group : {"ports", "properties", "attributes", "operations"}) {
        view[std::string("has_") + group] = !view[group].empty();
    }
    view["hasMembers"] = !component.ports.empty() || !component.properties.empty() || !component.attributes.empty();
    return view;
}

json registrationView(const model::Package& package, const std::string& manifest) {
    json view;
    view["banner"] = emit::banner(kTool, manifest);
    view["versionGuard"] = emit::versionGuard(kTool);
    view["components"] = listOf(package.components, [](const model::Component& component) {
        return json{{"class", lastName(component.className.value)}, {"qualified", component.className.value}};
    });
    view["single"] = package.components.size() == 1;
    return view;
}

}  // namespace oroforge::view
