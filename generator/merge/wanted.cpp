// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/wanted.hpp>

#include <model/doc_text.hpp>
#include <model/names.hpp>
#include <model/registration.hpp>

namespace oroforge::merge {

namespace {

/// Returns the text of doc(), which is left out if it is empty.
std::vector<DocText> textsOf(const std::string& doc) {
    if (doc.empty()) return {};
    return {{"", doc}};
}

WantedMethod operationMethod(const model::Operation& operation, const model::ServicePath& path,
                             const std::string& className) {
    const std::string& name = operation.name.value;
    WantedMethod method;
    method.name = model::methodName(path, name);
    method.shown = model::fullName(path, name);
    method.path = model::accessTo(path);
    method.operation = name;
    method.signature.returns = model::returnsOf(operation);
    method.where = operation.name.where;
    method.comment = model::commentLines(operation.doc);
    const std::string result = model::firstResult(operation);
    if (!result.empty()) method.body.push_back("return " + result + ";");
    method.registration = {model::threadOf(operation), textsOf(model::oneLine(operation.doc))};
    for (const model::Argument& argument : operation.arguments) {
        method.signature.arguments.push_back({argument.type.value, argument.name.value});
        method.registration.texts.push_back({argument.name.value, model::docWithUnit(argument.doc, argument.unit)});
    }
    method.registrationText = "addOperation(\"" + name + "\", &" + className + "::" + method.name +
                              ", this, RTT::" + method.registration.how + ")";
    return method;
}

template <class Part>
WantedMember memberOf(const Part& part, const char* kind, const model::ServicePath& path, const std::string& comment) {
    WantedMember member;
    member.kind = kind;
    member.name = part.name.value;
    member.shown = model::fullName(path, member.name);
    member.path = model::accessTo(path);
    member.method = model::methodName(path, member.name);
    member.type = member.declared = part.type.value;
    member.comment = comment;
    member.registration = {model::registrationOf(part), textsOf(comment)};
    member.where = part.name.where;
    return member;
}

WantedMember wantedMember(const model::Port& port, const model::ServicePath& path) {
    WantedMember member = memberOf(port, "port", path, model::oneLine(port.doc));
    member.portClass = model::portClass(port);
    return member;
}

template <class Value>
WantedMember valueMember(const Value& value, const char* kind, const model::ServicePath& path) {
    WantedMember member = memberOf(value, kind, path, model::docWithUnit(value.doc, value.unit));
    member.initialiser = model::initialiser(value.defaultValue, value.type.value);
    return member;
}

WantedMember wantedMember(const model::Property& property, const model::ServicePath& path) {
    return valueMember(property, "property", path);
}

WantedMember wantedMember(const model::Attribute& attribute, const model::ServicePath& path) {
    WantedMember member = valueMember(attribute, "attribute", path);
    member.declared = model::qualifierOf(attribute) + member.type;
    // Attributes have no description in the runtime.
    member.registration.texts.clear();
    return member;
}

/// Adds all members of one kind, those of services last.
template <class Part>
void addMembers(const model::Interface& top, std::vector<Part> model::Interface::*parts, WantedClass& into) {
    model::eachInterface(top, [&](const model::Interface& interface, const model::ServicePath& path) {
        for (const Part& part : interface.*parts) into.members.push_back(wantedMember(part, path));
    });
}

WantedClass wantedClass(const model::Interface& top, const model::Text& className) {
    WantedClass wanted;
    wanted.name = className.value;
    wanted.base = model::baseName(wanted.name);
    wanted.where = className.where;
    model::eachInterface(top, [&](const model::Interface& interface, const model::ServicePath& path) {
        for (const model::Operation& operation : interface.operations)
            wanted.methods.push_back(operationMethod(operation, path, model::lastName(wanted.name)));
    });
    addMembers(top, &model::Interface::ports, wanted);
    addMembers(top, &model::Interface::properties, wanted);
    addMembers(top, &model::Interface::attributes, wanted);
    return wanted;
}

WantedMethod hookMethod(const model::Hook& hook, const BodyOfHook& bodyOf, const diag::Location& where) {
    WantedMethod method;
    method.name = method.shown = model::methodName(hook);
    method.isHook = true;
    method.signature.returns = hook.returns;
    method.body = bodyOf(hook.name);
    method.where = where;
    return method;
}

}  // namespace

std::vector<WantedClass> wantedClasses(const model::Package& package, const BodyOfHook& bodyOf) {
    std::vector<WantedClass> all;
    for (const model::Component& component : package.components) {
        all.push_back(wantedClass(component, component.className));
        for (const model::Hook& hook : model::kHooks)
            if (component.hooks.*hook.wanted) all.back().methods.push_back(hookMethod(hook, bodyOf, component.where));
    }
    for (const model::ServicePlugin& service : package.services) {
        all.push_back(wantedClass(service, service.className));
        all.back().isComponent = false;
    }
    return all;
}

}  // namespace oroforge::merge
