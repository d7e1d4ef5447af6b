// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <check/check.hpp>

#include <map>

#include <model/names.hpp>

namespace oroforge::check {

namespace {

/// Remembers the owner of each name, and reports a second one.
class Names {
public:
    explicit Names(diag::Sink& sink) : sink_(sink) {}

    void add(const std::string& what, const model::Text& name) { add(what, name.value, name, {}); }

    void add(const std::string& what, const std::string& key, const model::Text& name, const std::string& why) {
        if (!name.given()) return;
        const auto [known, isNew] = owners_.emplace(key, Owner{what, name.where});
        if (isNew) return;
        sink_.error(name.where, "OM012", what + " name '" + name.value + "' is already used" + why)
            .note(known->second.where, "first used here, by " + article(known->second.what));
    }

private:
    struct Owner {
        std::string what;
        diag::Location where;
    };

    static std::string article(const std::string& what) {
        return (std::string("aeiou").find(what.front()) == std::string::npos ? "a " : "an ") + what;
    }

    diag::Sink& sink_;
    std::map<std::string, Owner> owners_;
};

void addOperation(Names& names, const model::Operation& operation, diag::Sink& sink) {
    names.add("operation", operation.name);
    Names argumentNames(sink);
    for (const auto& argument : operation.arguments) argumentNames.add("argument", argument.name);
}

/// All names of an interface share one set: they are members of one class, and ports are also services.
void checkInterface(const model::Interface& interface, diag::Sink& sink) {
    Names names(sink);
    for (const auto& port : interface.ports) names.add("port", port.name);
    for (const auto& property : interface.properties) names.add("property", property.name);
    for (const auto& attribute : interface.attributes) names.add("attribute", attribute.name);
    for (const auto& operation : interface.operations) addOperation(names, operation, sink);
    for (const auto& service : interface.services) names.add("service", service.name);
}

/// The generated class has members for all services: "gripper_open" for "open" of "gripper".
void addMembers(Names& members, const model::Interface& interface, const model::ServicePath& path) {
    const auto add = [&](const char* what, const model::Text& name) {
        const std::string member = model::methodName(path, name.value);
        const std::string why = "; in the generated class it is '" + member + "', as the other one";
        members.add(what, member, name, why);
    };
    for (const auto& port : interface.ports) add("port", port.name);
    for (const auto& property : interface.properties) add("property", property.name);
    for (const auto& attribute : interface.attributes) add("attribute", attribute.name);
    for (const auto& operation : interface.operations) add("operation", operation.name);
}

/// Skips interfaces in which checkInterface() found duplicates, to report each only once.
void checkMembers(const model::Interface& top, const std::vector<model::Requirement>& required, diag::Sink& sink) {
    Names members(sink);
    model::eachInterface(top, [&](const model::Interface& interface, const model::ServicePath& path) {
        const std::size_t before = sink.all().size();
        checkInterface(interface, sink);
        if (sink.all().size() == before) addMembers(members, interface, path);
    });
    Names services(sink);
    for (const auto& service : required) {
        services.add("service", service.name);
        const std::size_t before = sink.all().size();
        Names operations(sink);
        for (const auto& operation : service.operations) addOperation(operations, operation, sink);
        model::Interface callers;
        callers.operations = service.operations;
        if (sink.all().size() == before) addMembers(members, callers, {service.name.value});
    }
}

void checkClasses(const model::Package& package, diag::Sink& sink) {
    Names classes(sink);
    const auto add = [&](const model::Text& name) {
        if (!name.given()) return;
        const std::string last = model::lastName(name.value);
        const std::string why = "; the classes of a package make files of their unqualified names";
        classes.add("class", last, name, why);
        classes.add("class", model::baseName(last), name, why);
    };
    for (const auto& component : package.components) add(component.className);
    for (const auto& service : package.services) add(service.className);
    for (const auto& plugin : package.plugins) {
        classes.add("plugin", plugin.name.value, plugin.name, "; a file of that name in src/ is made for each");
    }
}

}  // namespace

void duplicates(const model::Package& package, diag::Sink& sink) {
    checkClasses(package, sink);
    Names dependencies(sink);
    for (const auto& dependency : package.dependencies) dependencies.add("package", dependency);
    Names headers(sink);
    for (const auto& header : package.typekitHeaders) headers.add("header", header);
    Names plugins(sink);
    for (const auto& service : package.services) plugins.add("service", service.name);
    for (const auto& plugin : package.plugins) plugins.add("plugin", plugin.name);
    for (const auto& component : package.components) checkMembers(component, component.required, sink);
    for (const auto& service : package.services) checkMembers(service, {}, sink);
}

}  // namespace oroforge::check
