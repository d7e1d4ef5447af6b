// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/package.hpp>

#include <nlohmann/json.hpp>

namespace oroforge::model {

namespace {

using Json = nlohmann::ordered_json;

Json place(const diag::Location& where) { return std::to_string(where.line) + ":" + std::to_string(where.column); }

void put(Json& into, const char* key, const std::string& text) {
    if (!text.empty()) into[key] = text;
}
void put(Json& into, const char* key, const Text& text) { put(into, key, text.value); }
void put(Json& into, const char* key, const std::optional<Number>& number) {
    if (number) into[key] = number->value;
}

Json toJson(const Argument& argument);
Json toJson(const Attribute& attribute);
Json toJson(const Component& component);
Json toJson(const Operation& operation);
Json toJson(const Person& person);
Json toJson(const Plugin& plugin);
Json toJson(const Port& port);
Json toJson(const Property& property);
Json toJson(const Requirement& required);
Json toJson(const Service& service);
Json toJson(const ServicePlugin& service);
Json toJson(const Text& text);

template <class T>
Json toJson(const std::vector<T>& items) {
    Json list = Json::array();
    for (const T& item : items) list.push_back(toJson(item));
    return list;
}

Json started(const Text& name) { return Json{{"name", name.value}, {"at", place(name.where)}}; }

Json toJson(const Policy& policy) {
    Json json{{"type", policy.type}};
    put(json, "size", policy.size);
    put(json, "lock", policy.lock);
    json["init"] = policy.init;
    json["pull"] = policy.pull;
    return json;
}

Json toJson(const Port& port) {
    Json json = started(port.name);
    json["direction"] = port.direction == Direction::In ? "in" : "out";
    put(json, "type", port.type);
    json["event"] = port.event;
    if (port.policy) json["policy"] = toJson(*port.policy);
    put(json, "doc", port.doc);
    return json;
}

Json toJson(const Value& value, bool constant) {
    Json json = started(value.name);
    put(json, "type", value.type);
    if (value.defaultValue.given()) json["default"] = value.defaultValue.value;
    if (constant) json["constant"] = true;
    put(json, "unit", value.unit);
    put(json, "min", value.minimum);
    put(json, "max", value.maximum);
    put(json, "doc", value.doc);
    return json;
}

Json toJson(const Property& property) { return toJson(property, false); }
Json toJson(const Attribute& attribute) { return toJson(attribute, attribute.constant); }

Json toJson(const Argument& argument) {
    Json json = started(argument.name);
    put(json, "type", argument.type);
    put(json, "unit", argument.unit);
    put(json, "doc", argument.doc);
    return json;
}

Json toJson(const Operation& operation) {
    Json json = started(operation.name);
    put(json, "returns", operation.returns);
    json["thread"] = operation.thread == Thread::Own ? "own" : "client";
    json["arguments"] = toJson(operation.arguments);
    put(json, "doc", operation.doc);
    return json;
}

template <class T>
void putList(Json& into, const char* key, const std::vector<T>& items) {
    if (!items.empty()) into[key] = toJson(items);
}

void putInterface(Json& json, const Interface& interface) {
    putList(json, "ports", interface.ports);
    putList(json, "properties", interface.properties);
    putList(json, "attributes", interface.attributes);
    putList(json, "operations", interface.operations);
    putList(json, "services", interface.services);
}

Json toJson(const Service& service) {
    Json json = started(service.name);
    put(json, "doc", service.doc);
    putInterface(json, service);
    return json;
}

Json toJson(const Requirement& required) {
    Json json = started(required.name);
    put(json, "doc", required.doc);
    putList(json, "operations", required.operations);
    return json;
}

Json toJson(const ServicePlugin& service) {
    Json json = started(service.name);
    put(json, "class", service.className);
    put(json, "doc", service.doc);
    putInterface(json, service);
    return json;
}

Json toJson(const Plugin& plugin) {
    Json json = started(plugin.name);
    put(json, "doc", plugin.doc);
    return json;
}

Json toJson(const Activity& activity) {
    Json json{{"kind", word(activity.kind)}};
    put(json, "period", activity.period);
    put(json, "priority", activity.priority);
    put(json, "scheduler", activity.scheduler);
    return json;
}

Json toJson(const Hooks& hooks) {
    Json json = Json::array();
    const std::pair<const char*, bool> all[] = {
        {"configure", hooks.configure}, {"start", hooks.start}, {"update", hooks.update},      {"stop", hooks.stop},
        {"cleanup", hooks.cleanup},     {"error", hooks.error}, {"exception", hooks.exception}};
    for (const auto& [name, wanted] : all) {
        if (wanted) json.push_back(name);
    }
    return json;
}

Json toJson(const Component& component) {
    Json json{{"class", component.className.value}, {"at", place(component.className.where)}};
    json["initial"] = component.initial == InitialState::Stopped ? "Stopped" : "PreOperational";
    if (component.activity) json["activity"] = toJson(*component.activity);
    if (component.dynamic) json["dynamic"] = true;
    put(json, "doc", component.doc);
    putInterface(json, component);
    putList(json, "required", component.required);
    json["hooks"] = toJson(component.hooks);
    return json;
}

Json toJson(const Person& person) {
    Json json = started(person.name);
    put(json, "email", person.email);
    return json;
}

Json toJson(const Text& text) { return started(text); }

}  // namespace

std::string dump(const Package& package) {
    Json json = started(package.name);
    put(json, "version", package.version);
    put(json, "license", package.license);
    put(json, "description", package.description);
    putList(json, "maintainers", package.maintainers);
    putList(json, "authors", package.authors);
    putList(json, "dependencies", package.dependencies);
    putList(json, "typekits", package.typekitHeaders);
    putList(json, "components", package.components);
    putList(json, "services", package.services);
    putList(json, "plugins", package.plugins);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace oroforge::model
