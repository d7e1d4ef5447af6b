// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/wanted_classes.hpp>

#include <map>
#include <sstream>

#include <nlohmann/json.hpp>

#include <merge/plan.hpp>
#include <model/interfaces.hpp>
#include <view/cpp_text.hpp>
#include <view/view.hpp>

namespace oroforge::driver {

namespace {

using nlohmann::json;

std::string textOr(const json& value, const char* key) {
    return value.contains(key) && value[key].is_string() ? value[key].get<std::string>() : std::string();
}

/// What a literal made by view::stringLiteral() says.
std::string wordsOf(const std::string& literal) {
    std::string words;
    for (std::size_t at = 1; at + 1 < literal.size(); ++at) {
        const bool escaped = literal[at] == '\\';
        if (escaped) ++at;
        words += !escaped ? literal[at] : literal[at] == 'n' ? '\n' : literal[at] == 't' ? '\t' : literal[at];
    }
    return words;
}

void addText(const std::string& literal, const std::string& argument, merge::WantedRegistration& into) {
    if (!literal.empty()) into.texts.push_back({argument, wordsOf(literal), literal});
}

/// Lines between the first '{' and the last '}', one level of indentation taken off.
std::vector<std::string> bodyIn(const std::string& definition) {
    std::vector<std::string> lines;
    std::istringstream in(definition.substr(0, definition.rfind('}')));
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        if (inside) lines.push_back(line.compare(0, 4, "    ") == 0 ? line.substr(4) : line);
        inside = inside || (!line.empty() && line.back() == '{');
    }
    return lines;
}

merge::WantedMethod hookMethod(const std::string& hook, const std::string& className, const diag::Location& where,
                               const render::Renderer& renderer) {
    merge::WantedMethod method;
    method.name = method.shown = hook + "Hook";
    method.isHook = true;
    method.signature.returns = hook == "configure" || hook == "start" ? "bool" : "void";
    method.body =
        bodyIn(renderer.render("partials/hook_definitions", {{"class", className}, {"hooks", {{hook, true}}}}));
    method.where = where;
    return method;
}

/// In the order in which templates/component/user.hpp has them.
std::vector<std::string> hooksOf(const model::Hooks& hooks) {
    std::vector<std::string> names;
    const auto add = [&](bool wanted, const char* name) {
        if (wanted) names.push_back(name);
    };
    add(hooks.configure, "configure");
    add(hooks.start, "start");
    add(hooks.update, "update");
    add(hooks.error, "error");
    add(hooks.exception, "exception");
    add(hooks.stop, "stop");
    add(hooks.cleanup, "cleanup");
    return names;
}

merge::WantedMethod operationMethod(const json& view, const std::string& className, const diag::Location& where) {
    merge::WantedMethod method;
    method.name = view["method"];
    method.shown = view["fullName"];
    method.path = view["path"];
    method.operation = view["name"];
    method.signature.returns = view["returns"];
    method.where = where;
    for (const json& line : view["comment"]) method.comment.push_back(line);
    const std::string result = textOr(view, "result");
    if (!result.empty()) method.body.push_back("return " + result + ";");
    method.registration.how = view["thread"];
    addText(textOr(view, "doc"), "", method.registration);
    for (const json& argument : view["args"]) {
        method.signature.arguments.push_back({argument["type"], argument["name"]});
        addText(argument["doc"], argument["name"], method.registration);
    }
    method.registrationText = "addOperation(\"" + method.operation + "\", &" + className + "::" + method.name +
                              ", this, RTT::" + method.registration.how + ")";
    return method;
}

merge::WantedMember memberFrom(const json& view, const char* kind, const diag::Location& where) {
    merge::WantedMember member;
    member.kind = kind;
    member.name = view["name"];
    member.shown = view["fullName"];
    member.path = view["path"];
    member.method = view["method"];
    member.type = view["type"];
    member.declared = textOr(view, "qualifier") + member.type;
    member.portClass = textOr(view, "portClass");
    member.initialiser = textOr(view, "init");
    member.comment = textOr(view, "comment");
    member.registration.how = textOr(view, "add");
    if (member.registration.how.empty()) member.registration.how = "addProperty";
    // Attributes have no description in the runtime.
    if (std::string(kind) != "attribute") addText(textOr(view, "doc"), "", member.registration);
    member.where = where;
    return member;
}

/// Where in the manifest things stand, in the order in which views list them.
struct Places {
    std::vector<diag::Location> ports, properties, attributes, operations;
};

Places placesIn(const model::Interface& top) {
    Places places;
    model::eachInterface(top, [&](const model::Interface& interface, const model::ServicePath&) {
        for (const auto& one : interface.ports) places.ports.push_back(one.name.where);
        for (const auto& one : interface.properties) places.properties.push_back(one.name.where);
        for (const auto& one : interface.attributes) places.attributes.push_back(one.name.where);
        for (const auto& one : interface.operations) places.operations.push_back(one.name.where);
    });
    return places;
}

merge::WantedClass classFrom(const json& view, const model::Interface& top, const diag::Location& where) {
    merge::WantedClass wanted;
    wanted.name = view["qualified"];
    wanted.base = wanted.name + "Base";
    wanted.where = where;
    const Places places = placesIn(top);
    const std::string className = view["class"];
    for (std::size_t i = 0; i != places.operations.size(); ++i)
        wanted.methods.push_back(operationMethod(view["operations"][i], className, places.operations[i]));
    const auto addMembers = [&](const char* group, const char* kind, const std::vector<diag::Location>& locations) {
        for (std::size_t i = 0; i != locations.size(); ++i)
            wanted.members.push_back(memberFrom(view[group][i], kind, locations[i]));
    };
    addMembers("ports", "port", places.ports);
    addMembers("properties", "property", places.properties);
    addMembers("attributes", "attribute", places.attributes);
    return wanted;
}

}  // namespace

std::vector<merge::WantedClass> wantedClasses(const model::Package& package, const std::string& manifest,
                                              const render::Renderer& renderer) {
    std::vector<merge::WantedClass> all;
    for (const model::Component& component : package.components) {
        const json view = view::componentView(package, component, manifest);
        all.push_back(classFrom(view, component, component.className.where));
        for (const std::string& hook : hooksOf(component.hooks))
            all.back().methods.push_back(hookMethod(hook, view["class"], component.where, renderer));
    }
    for (const model::ServicePlugin& service : package.services) {
        all.push_back(classFrom(view::serviceView(package, service, manifest), service, service.className.where));
        all.back().isComponent = false;
    }
    return all;
}

std::string firstRecord(const model::Package& package, const std::string& manifest, const render::Renderer& renderer) {
    merge::Record record;
    for (const merge::WantedClass& wanted : wantedClasses(package, manifest, renderer))
        record[wanted.name] = merge::recordOf(wanted);
    return record.empty() ? std::string() : merge::toText(record);
}

}  // namespace oroforge::driver
