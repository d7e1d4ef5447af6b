// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <check/check.hpp>

#include <map>

#include <model/cpp_type.hpp>

namespace oroforge::check {

namespace {

/// Remembers who has a name, and complains about the second.
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

void checkComponent(const model::Component& component, diag::Sink& sink) {
    // One set for all: they are members of one class, and ports are services of their name.
    Names names(sink);
    for (const auto& port : component.ports) names.add("port", port.name);
    for (const auto& property : component.properties) names.add("property", property.name);
    for (const auto& attribute : component.attributes) names.add("attribute", attribute.name);
    for (const auto& operation : component.operations) {
        names.add("operation", operation.name);
        Names argumentNames(sink);
        for (const auto& argument : operation.arguments) argumentNames.add("argument", argument.name);
    }
    Names required(sink);
    for (const auto& service : component.services) {
        (service.role == model::ServiceRole::Provided ? names : required).add("service", service.name);
    }
}

void checkClasses(const model::Package& package, diag::Sink& sink) {
    Names classes(sink);
    for (const auto& component : package.components) {
        if (!component.className.given()) continue;
        const std::string last = model::splitQualified(component.className.value).back();
        const std::string why = "; the classes of a package make files of their unqualified names";
        classes.add("class", last, component.className, why);
        classes.add("class", last + "Base", component.className, why);
    }
}

}  // namespace

void duplicates(const model::Package& package, diag::Sink& sink) {
    checkClasses(package, sink);
    Names dependencies(sink);
    for (const auto& dependency : package.dependencies) dependencies.add("package", dependency);
    Names headers(sink);
    for (const auto& header : package.typekitHeaders) headers.add("header", header);
    for (const auto& component : package.components) checkComponent(component, sink);
}

}  // namespace oroforge::check
