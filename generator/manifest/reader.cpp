// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <manifest/reader.hpp>

#include <cstdlib>

#include <manifest/schema.hpp>
#include <model/literal.hpp>
#include <xml/document.hpp>

namespace oroforge::manifest {

namespace {

using xml::Element;

model::Text text(const Element& element, const char* name) {
    const xml::Attribute* found = element.attribute(name);
    return found == nullptr ? model::Text{} : model::Text{found->value, found->valueWhere};
}

/// Returns nothing if the number is absent or malformed; the structure check has reported the latter.
std::optional<model::Number> number(const Element& element, const char* name) {
    const xml::Attribute* found = element.attribute(name);
    if (found == nullptr || !model::isNumberText(found->value)) return std::nullopt;
    return model::Number{found->value, std::strtod(found->value.c_str(), nullptr), found->valueWhere};
}

bool flag(const Element& element, const char* name, bool fallback) {
    return element.attributeOr(name, fallback ? "true" : "false") == "true";
}

std::string docOf(const Element& element) {
    const Element* child = element.child("doc");
    return child != nullptr ? child->text : element.attributeOr("doc", "");
}

std::optional<model::Policy> readPolicy(const Element& port) {
    const Element* element = port.child("policy");
    if (element == nullptr) return std::nullopt;
    model::Policy policy;
    policy.type = element->attributeOr("type", "data");
    policy.size = number(*element, "size");
    // The structure check has reported these values already.
    const bool knownType = policy.type == "data" || policy.type == "buffer" || policy.type == "circular_buffer";
    if (!knownType || (element->hasAttribute("size") && !policy.size)) return std::nullopt;
    policy.lock = element->attributeOr("lock", "");
    // As in RTT::ConnPolicy, only data connections start with the last value of the output.
    policy.init = flag(*element, "init", policy.type == "data");
    policy.pull = flag(*element, "pull", false);
    policy.where = element->where;
    return policy;
}

model::Port readPort(const Element& element) {
    model::Port port;
    port.name = text(element, "name");
    port.direction = element.attributeOr("direction", "in") == "out" ? model::Direction::Out : model::Direction::In;
    port.type = text(element, "type");
    port.event = flag(element, "event", false);
    if (const auto* event = element.attribute("event")) port.eventWhere = event->where;
    port.policy = readPolicy(element);
    port.doc = docOf(element);
    port.where = element.where;
    return port;
}

model::Value readValue(const Element& element) {
    model::Value value;
    value.name = text(element, "name");
    value.type = text(element, "type");
    value.defaultValue = text(element, "default");
    value.minimum = number(element, "min");
    value.maximum = number(element, "max");
    value.unit = element.attributeOr("unit", "");
    value.doc = docOf(element);
    value.where = element.where;
    return value;
}

model::Operation readOperation(const Element& element) {
    model::Operation operation;
    operation.name = text(element, "name");
    operation.returns = text(element, "returns");
    operation.thread = element.attributeOr("thread", "client") == "own" ? model::Thread::Own : model::Thread::Client;
    for (const Element* arg : element.childrenNamed("arg")) {
        operation.arguments.push_back(
            {text(*arg, "name"), text(*arg, "type"), arg->attributeOr("unit", ""), docOf(*arg), arg->where});
    }
    operation.doc = docOf(element);
    operation.where = element.where;
    return operation;
}

model::Requirement readRequirement(const Element& element) {
    model::Requirement required;
    required.name = text(element, "service");
    for (const Element* operation : element.childrenNamed("operation")) {
        required.operations.push_back(readOperation(*operation));
    }
    required.doc = docOf(element);
    required.where = element.where;
    return required;
}

model::Service readService(const Element& element);

void readInterface(const Element& element, model::Interface& interface) {
    for (const Element& child : element.children) {
        if (child.name == "port") interface.ports.push_back(readPort(child));
        if (child.name == "property") interface.properties.push_back({readValue(child)});
        if (child.name == "attribute")
            interface.attributes.push_back({readValue(child), flag(child, "constant", false)});
        if (child.name == "operation") interface.operations.push_back(readOperation(child));
        if (child.name == "provides") interface.services.push_back(readService(child));
    }
}

model::Service readService(const Element& element) {
    model::Service service;
    readInterface(element, service);
    service.name = text(element, "service");
    service.doc = docOf(element);
    service.where = element.where;
    return service;
}

model::ServicePlugin readServicePlugin(const Element& element) {
    model::ServicePlugin service;
    readInterface(element, service);
    service.name = text(element, "name");
    service.className = text(element, "class");
    service.doc = docOf(element);
    service.where = element.where;
    return service;
}

std::optional<model::Activity> readActivity(const Element& element) {
    if (!element.hasAttribute("activity") && !element.hasAttribute("period") && !element.hasAttribute("priority") &&
        !element.hasAttribute("scheduler")) {
        return std::nullopt;
    }
    model::Activity activity;
    const bool hasPeriod = element.hasAttribute("period");
    const std::string kind = element.attributeOr("activity", hasPeriod ? "periodic" : "nonperiodic");
    if (kind == "periodic") activity.kind = model::ActivityKind::Periodic;
    if (kind == "sequential") activity.kind = model::ActivityKind::Sequential;
    if (kind == "slave") activity.kind = model::ActivityKind::Slave;
    activity.period = number(element, "period");
    activity.priority = number(element, "priority");
    activity.scheduler = text(element, "scheduler");
    const auto* attribute = element.attribute("activity");
    activity.where = attribute != nullptr ? attribute->where : element.where;
    return activity;
}

/// Without <hooks>, a component has the five usual ones; with it, exactly those listed.
model::Hooks readHooks(const Element& component) {
    const Element* element = component.child("hooks");
    model::Hooks hooks;
    if (element == nullptr) return hooks;
    for (const model::Hook& hook : model::kHooks) hooks.*hook.wanted = flag(*element, hook.name, false);
    return hooks;
}

model::Component readComponent(const Element& element) {
    model::Component component;
    component.className = text(element, "class");
    if (element.attributeOr("initial", "Stopped") == "PreOperational") {
        component.initial = model::InitialState::PreOperational;
    }
    component.activity = readActivity(element);
    component.doc = docOf(element);
    readInterface(element, component);
    for (const Element* child : element.childrenNamed("requires")) {
        component.required.push_back(readRequirement(*child));
    }
    component.hooks = readHooks(element);
    component.dynamic = flag(element, "dynamic", false);
    component.where = element.where;
    return component;
}

model::Package readPackage(const Element& root) {
    model::Package package;
    package.name = text(root, "name");
    package.version = text(root, "version");
    package.license = text(root, "license");
    if (const Element* description = root.child("description")) package.description = description->text;
    for (const Element& child : root.children) {
        if (child.name == "maintainer") package.maintainers.push_back({text(child, "name"), text(child, "email")});
        if (child.name == "author") package.authors.push_back({text(child, "name"), text(child, "email")});
        if (child.name == "depend") package.dependencies.push_back(text(child, "package"));
        if (child.name == "typekit") package.typekitHeaders.push_back(text(child, "header"));
        if (child.name == "component") package.components.push_back(readComponent(child));
        if (child.name == "service") package.services.push_back(readServicePlugin(child));
        if (child.name == "plugin") package.plugins.push_back({text(child, "name"), docOf(child), child.where});
    }
    package.where = root.where;
    return package;
}

std::optional<model::Package> read(const std::optional<xml::Document>& document, diag::Sink& sink) {
    if (!document) return std::nullopt;
    const Element& root = document->root();
    if (root.name != "package") {
        sink.error(root.where, "OM006", "found the root element <" + root.name + ">, expected <package>");
        return std::nullopt;
    }
    checkStructure(root, sink);
    return readPackage(root);
}

}  // namespace

std::optional<model::Package> readFile(const std::string& path, diag::Sink& sink) {
    return read(xml::Document::parseFile(path, sink), sink);
}

std::optional<model::Package> readText(const std::string& content, const std::string& name, diag::Sink& sink) {
    return read(xml::Document::parseText(content, name, sink), sink);
}

}  // namespace oroforge::manifest
