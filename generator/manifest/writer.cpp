// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <manifest/writer.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include <xml/escape.hpp>

namespace oroforge::manifest {

namespace {

/// An element under construction.
class Node {
public:
    explicit Node(std::string name) : name_(std::move(name)) {}

    Node& set(const char* name, const std::string& value) {
        attributes_ += std::string(" ") + name + "=\"" + xml::escapeExactly(value, /*inAttribute=*/true) + "\"";
        return *this;
    }
    Node& setIf(bool wanted, const char* name, const std::string& value) { return wanted ? set(name, value) : *this; }
    Node& setGiven(const char* name, const model::Text& text) { return setIf(text.given(), name, text.value); }
    Node& setGiven(const char* name, const std::optional<model::Number>& number) {
        return number ? set(name, number->text) : *this;
    }
    Node& setFlag(const char* name, bool value, bool byDefault) {
        return setIf(value != byDefault, name, value ? "true" : "false");
    }

    Node& add(Node child) {
        children_.push_back(std::move(child));
        return *this;
    }
    Node& doc(const std::string& text) {
        if (text.empty()) return *this;
        Node child("doc");
        return add(child.text(text));
    }
    Node& text(const std::string& text) {
        text_ = text;
        return *this;
    }

    void print(std::string& into, const std::string& indent) const {
        into += indent + "<" + name_ + attributes_;
        if (children_.empty()) {
            into += text_.empty() ? "/>\n" : ">" + xml::escapeExactly(text_) + "</" + name_ + ">\n";
            return;
        }
        // An element whose only child is text, such as a port with its documentation, takes one line.
        if (children_.size() == 1 && children_[0].children_.empty() && !children_[0].text_.empty() &&
            name_ != "component") {
            std::string only;
            children_[0].print(only, "");
            only.pop_back();
            into += ">" + only + "</" + name_ + ">\n";
            return;
        }
        into += ">\n";
        for (const Node& child : children_) child.print(into, indent + "  ");
        into += indent + "</" + name_ + ">\n";
    }

private:
    std::string name_;
    std::string attributes_;
    std::string text_;
    std::vector<Node> children_;
};

Node portNode(const model::Port& port) {
    Node node("port");
    node.set("name", port.name.value).set("direction", port.direction == model::Direction::In ? "in" : "out");
    node.set("type", port.type.value).setFlag("event", port.event, false).doc(port.doc);
    if (port.policy) {
        const model::Policy& policy = *port.policy;
        Node child("policy");
        child.set("type", policy.type).setGiven("size", policy.size).setIf(!policy.lock.empty(), "lock", policy.lock);
        child.setFlag("init", policy.init, policy.type == "data").setFlag("pull", policy.pull, false);
        node.add(std::move(child));
    }
    return node;
}

Node valueNode(const char* kind, const model::Value& value, bool constant) {
    Node node(kind);
    node.set("name", value.name.value).set("type", value.type.value).setFlag("constant", constant, false);
    node.setGiven("default", value.defaultValue).setIf(!value.unit.empty(), "unit", value.unit);
    node.setGiven("min", value.minimum).setGiven("max", value.maximum).doc(value.doc);
    return node;
}

Node operationNode(const model::Operation& operation) {
    Node node("operation");
    node.set("name", operation.name.value).setGiven("returns", operation.returns);
    node.setIf(operation.thread == model::Thread::Own, "thread", "own").doc(operation.doc);
    for (const model::Argument& argument : operation.arguments) {
        Node child("arg");
        child.set("name", argument.name.value).set("type", argument.type.value);
        child.setIf(!argument.unit.empty(), "unit", argument.unit).doc(argument.doc);
        node.add(std::move(child));
    }
    return node;
}

void addInterface(const model::Interface& interface, Node& node) {
    for (const auto& port : interface.ports) node.add(portNode(port));
    for (const auto& property : interface.properties) node.add(valueNode("property", property, false));
    for (const auto& one : interface.attributes) node.add(valueNode("attribute", one, one.constant));
    for (const auto& operation : interface.operations) node.add(operationNode(operation));
    for (const auto& service : interface.services) {
        Node child("provides");
        child.set("service", service.name.value).doc(service.doc);
        addInterface(service, child);
        node.add(std::move(child));
    }
}

void addActivity(const model::Activity& activity, Node& node) {
    const auto usual = activity.period ? model::ActivityKind::Periodic : model::ActivityKind::NonPeriodic;
    const bool others = activity.period || activity.priority || activity.scheduler.given();
    node.setIf(activity.kind != usual || !others, "activity", model::word(activity.kind));
    node.setGiven("period", activity.period).setGiven("priority", activity.priority);
    node.setGiven("scheduler", activity.scheduler);
}

void addHooks(const model::Hooks& hooks, Node& node) {
    const model::Hooks usual;
    const std::pair<const char*, bool model::Hooks::*> all[] = {
        {"configure", &model::Hooks::configure}, {"start", &model::Hooks::start},     {"update", &model::Hooks::update},
        {"stop", &model::Hooks::stop},           {"cleanup", &model::Hooks::cleanup}, {"error", &model::Hooks::error},
        {"exception", &model::Hooks::exception}};
    if (std::all_of(std::begin(all), std::end(all),
                    [&](const auto& one) { return hooks.*one.second == usual.*one.second; }))
        return;
    Node child("hooks");
    for (const auto& [name, hook] : all) child.setFlag(name, hooks.*hook, false);
    node.add(std::move(child));
}

Node componentNode(const model::Component& component) {
    Node node("component");
    node.set("class", component.className.value);
    node.setIf(component.initial == model::InitialState::PreOperational, "initial", "PreOperational");
    if (component.activity) addActivity(*component.activity, node);
    node.setFlag("dynamic", component.dynamic, false);
    node.doc(component.doc);
    addInterface(component, node);
    for (const model::Requirement& required : component.required) {
        Node child("requires");
        child.set("service", required.name.value).doc(required.doc);
        for (const auto& operation : required.operations) child.add(operationNode(operation));
        node.add(std::move(child));
    }
    addHooks(component.hooks, node);
    return node;
}

Node personNode(const char* role, const model::Person& person) {
    Node node(role);
    node.set("name", person.name.value).setGiven("email", person.email);
    return node;
}

Node packageNode(const model::Package& package) {
    Node node("package");
    node.set("name", package.name.value).setGiven("version", package.version).setGiven("license", package.license);
    if (!package.description.empty()) {
        Node child("description");
        node.add(child.text(package.description));
    }
    for (const auto& person : package.maintainers) node.add(personNode("maintainer", person));
    for (const auto& person : package.authors) node.add(personNode("author", person));
    for (const auto& dependency : package.dependencies) {
        Node child("depend");
        node.add(child.set("package", dependency.value));
    }
    for (const auto& header : package.typekitHeaders) {
        Node child("typekit");
        node.add(child.set("header", header.value));
    }
    for (const auto& component : package.components) node.add(componentNode(component));
    for (const auto& service : package.services) {
        Node child("service");
        child.set("class", service.className.value).set("name", service.name.value).doc(service.doc);
        addInterface(service, child);
        node.add(std::move(child));
    }
    for (const auto& plugin : package.plugins) {
        Node child("plugin");
        node.add(child.set("name", plugin.name.value).doc(plugin.doc));
    }
    return node;
}

}  // namespace

std::string write(const model::Package& package) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    packageNode(package).print(text, "");
    return text;
}

}  // namespace oroforge::manifest
