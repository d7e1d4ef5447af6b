// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <charconv>

#include "evaluator.hpp"

namespace oroforge::cxx {

namespace {

using Kind = Value::Kind;

model::Text textAt(std::string value, const diag::Location& where) { return {std::move(value), where}; }

template <class Number>
std::string shortest(Number value) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end.ptr};
}

class InterfaceResult : Part {
public:
    explicit InterfaceResult(const Part& parts) : Part(parts) {}
    void readInto(Followed& made);

private:
    void read(const Scope& scope, model::Interface& into);
    void read(const Element& element, model::Interface& into);
    model::Operation operationOf(const Element& element) const;
    model::Value valueOf(const Element& element, const std::string& what);
    void giveValue(const Element& element, model::Text& value, const std::string& what);
    std::optional<std::string> literal(const Value& value, clang::QualType type) const;

    std::vector<clang::QualType> uses_;
};

void InterfaceResult::readInto(Followed& made) {
    made.activity = registry_.activity;
    made.initial = registry_.initial;
    if (const Scope* root = registry_.scopeAt(Place::component())) {
        read(*root, made.interface);
        made.serviceName = root->name;
        made.doc = root->doc;
    }
    for (const auto& [place, requester] : registry_.requesters) {
        if (!place.isOf(Place::Kind::Requester) || (requester->name == "this" && requester->callers.empty())) continue;
        model::Requirement required;
        required.name = textAt(requester->name, requester->where);
        required.where = requester->where;
        for (const Place& caller : requester->callers) {
            const Element& element = registry_.elements[caller];
            required.operations.push_back(operationOf(element));
            uses_.insert(uses_.end(), element.uses.begin(), element.uses.end());
        }
        made.required.push_back(std::move(required));
    }
    std::sort(made.required.begin(), made.required.end(),
              [](const auto& a, const auto& b) { return a.name.value < b.name.value; });
    made.uses = std::move(uses_);
}

void InterfaceResult::read(const Scope& scope, model::Interface& into) {
    for (const Place& place : scope.elements) read(registry_.elements[place], into);
    for (const Scope* one : scope.services) {
        model::Service service;
        service.name = textAt(one->name, one->where);
        service.doc = one->doc;
        service.where = one->where;
        read(*one, service);
        into.services.push_back(std::move(service));
    }
}

model::Operation InterfaceResult::operationOf(const Element& element) const {
    model::Operation operation;
    operation.name = textAt(element.name.value_or(""), element.where);
    if (element.result != "void") operation.returns = textAt(element.result, element.where);
    operation.thread = element.own ? model::Thread::Own : model::Thread::Client;
    operation.arguments = element.arguments;
    for (model::Argument& argument : operation.arguments) {
        if (argument.where.line == 0) argument.where = element.where;
        argument.name.where = argument.type.where = argument.where;
    }
    operation.doc = element.doc;
    operation.where = element.where;
    return operation;
}

void InterfaceResult::read(const Element& element, model::Interface& into) {
    uses_.insert(uses_.end(), element.uses.begin(), element.uses.end());
    if (element.kind == ElementKind::Port) {
        model::Port port;
        port.name = textAt(*element.name, element.where);
        port.type = textAt(element.type, element.where);
        port.direction = element.output ? model::Direction::Out : model::Direction::In;
        port.event = element.event;
        port.eventWhere = port.where = element.where;
        port.policy = element.policy;
        port.doc = element.doc;
        into.ports.push_back(std::move(port));
    } else if (element.kind == ElementKind::Property) {
        into.properties.push_back({valueOf(element, "property")});
        into.properties.back().doc = element.doc;
    } else if (element.kind == ElementKind::Attribute) {
        into.attributes.push_back({valueOf(element, element.constant ? "constant" : "attribute"), element.constant});
    } else if (element.kind == ElementKind::Operation) {
        into.operations.push_back(operationOf(element));
    }
}

model::Value InterfaceResult::valueOf(const Element& element, const std::string& what) {
    model::Value value;
    value.name = textAt(*element.name, element.where);
    value.type = textAt(element.type, element.where);
    value.where = element.where;
    giveValue(element, value.defaultValue, what);
    return value;
}

/// Sets the value that the variable has at the end of the constructor.
void InterfaceResult::giveValue(const Element& element, model::Text& value, const std::string& what) {
    const Value* found = memory_.find(element.value);
    const bool changed = memory_.find(element.value.of(Place::Kind::Changed)) != nullptr;
    const clang::FunctionDecl* unseen = found == nullptr ? objects_.unseenMaker(element.value) : nullptr;
    if (found == nullptr && !changed && unseen == nullptr) {
        if (element.constant) findings_.warn(element.where, "OC024", "the value of this constant cannot be told");
        return;
    }
    if (unseen != nullptr) findings_.noteUnseen(*unseen);
    const auto text = changed || found == nullptr ? std::nullopt : literal(*found, element.valueType);
    if (!text) {
        findings_.warn(element.where, "OC024", "the initial value of this " + what + " is not constant");
        return;
    }
    const bool isDefault = !element.constant && (*text == "0" || *text == "false" || text->empty());
    if (!isDefault) value = textAt(*text, element.where);
}

std::optional<std::string> InterfaceResult::literal(const Value& value, clang::QualType type) const {
    type = type.getNonReferenceType().getUnqualifiedType();
    if (value.is(Kind::Text)) return value.text;
    if (value.is(Kind::Cpp)) return value.text;
    if (type->isEnumeralType())
        return value.is(Kind::Number) && !value.text.empty() ? std::optional(value.text) : std::nullopt;
    const Value number = values_.converted(value, type);
    if (number.is(Kind::Boolean)) return std::string(number.number != 0 ? "true" : "false");
    if (number.is(Kind::Real)) {
        if (context_.hasSameType(type, context_.FloatTy)) return shortest(static_cast<float>(number.real));
        return shortest(number.real);
    }
    if (!number.is(Kind::Number)) return std::nullopt;
    if (type->isCharType() && context_.hasSameType(type, context_.CharTy))
        return std::string(1, static_cast<char>(number.number));
    return type->isSignedIntegerOrEnumerationType() ? shortest(number.number)
                                                    : shortest(static_cast<unsigned long long>(number.number));
}

}  // namespace

void readResult(const Part& parts, Followed& made) { InterfaceResult(parts).readInto(made); }

}  // namespace oroforge::cxx
