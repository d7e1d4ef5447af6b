// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <charconv>

#include "follow.hpp"

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

/// In the order of their registration.
template <class Item>
void byName(std::vector<Item>& items) {
    std::stable_sort(items.begin(), items.end(),
                     [](const Item& a, const Item& b) { return a.name.value < b.name.value; });
}

}  // namespace

Follower::Follower(clang::ASTContext& context, const SourcePlaces& places, diag::Sink& remarks)
    : context_(context), places_(places), remarks_(remarks) {}

diag::Location Follower::locate(clang::SourceLocation at) const {
    return places_.locate(context_.getSourceManager(), at);
}

diag::Diagnostic& Follower::remark(clang::SourceLocation at, const char* code, const std::string& message) {
    // Of what happens later only what it adds matters.
    return (late_.empty() ? remarks_ : unused_).warning(locate(at), code, message);
}

/// A class that computes for long, or for ever, is not worth it.
bool Follower::isTooMuch(clang::SourceLocation at) {
    constexpr unsigned most = 1000000;
    if (++steps_ == most) {
        hasMore_ |= late_.empty();
        remark(at, "OC022", "the constructor does more than is followed; what comes from here on is left out");
    }
    return steps_ >= most;
}

bool Follower::isTooDeep(clang::SourceLocation at) {
    constexpr std::size_t deepest = 64;
    if (frames_.size() < deepest) return false;
    hasMore_ |= late_.empty();
    remark(at, "OC022", "functions call each other deeper than is followed; what this one does is left out");
    return true;
}

Followed Follower::follow(const clang::CXXConstructorDecl& constructor) {
    Frame outermost;
    outermost.self = kRoot;
    frames_.push_back(outermost);
    Values arguments;
    for (const clang::ParmVarDecl* parameter : constructor.parameters()) {
        // An inherited constructor is called with the defaults of the one it stands for.
        const unsigned i = parameter->getFunctionScopeIndex();
        const clang::CXXConstructorDecl* inherited = constructor.getInheritedConstructor().getConstructor();
        if (inherited != nullptr) parameter = inherited->getParamDecl(i);
        const bool hasDefault = parameter->hasDefaultArg() && !parameter->hasUninstantiatedDefaultArg();
        arguments.push_back(hasDefault ? eval(parameter->getDefaultArg()) : Value());
    }
    construct(kRoot, constructor, arguments);
    Followed made;
    made.activity = activity_;
    made.initial = initial_;
    if (const Scope* root = scopeAt(kRoot)) {
        result(*root, made.interface);
        made.serviceName = root->name;
        made.doc = root->doc;
    }
    for (const auto& [place, requester] : requesters_) {
        if (place.rfind("requester ", 0) != 0 || (requester->name == "this" && requester->callers.empty())) continue;
        model::Requirement required;
        required.name = textAt(requester->name, requester->where);
        required.where = requester->where;
        for (const Place& caller : requester->callers) {
            const Element& element = elements_[caller];
            required.operations.push_back(operationOf(element));
            uses_.insert(uses_.end(), element.uses.begin(), element.uses.end());
        }
        made.required.push_back(std::move(required));
    }
    byName(made.required);
    made.uses = uses_;
    followLate(*constructor.getParent());
    made.hasMore = hasMore_;
    return made;
}

void Follower::result(const Scope& scope, model::Interface& into) {
    for (const Place& place : scope.elements) resultOf(elements_[place], into);
    for (const Scope* one : scope.services) {
        model::Service service;
        service.name = textAt(one->name, one->where);
        service.doc = one->doc;
        service.where = one->where;
        result(*one, service);
        into.services.push_back(std::move(service));
    }
}

model::Operation Follower::operationOf(const Element& element) const {
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

void Follower::resultOf(Element& element, model::Interface& into) {
    uses_.insert(uses_.end(), element.uses.begin(), element.uses.end());
    const model::Text name = textAt(*element.name, element.where), type = textAt(element.type, element.where);
    if (element.kind == ElementKind::Port) {
        model::Port port;
        port.name = name;
        port.type = type;
        port.direction = element.output ? model::Direction::Out : model::Direction::In;
        port.event = element.event;
        port.eventWhere = port.where = element.where;
        port.policy = element.policy;
        port.doc = element.doc;
        into.ports.push_back(std::move(port));
    } else if (element.kind == ElementKind::Property) {
        model::Property property;
        property.name = name;
        property.type = type;
        property.doc = element.doc;
        property.where = element.where;
        giveValue(element, property.defaultValue, "property");
        into.properties.push_back(std::move(property));
    } else if (element.kind == ElementKind::Attribute) {
        model::Attribute attribute;
        attribute.name = name;
        attribute.type = type;
        attribute.constant = element.constant;
        attribute.where = element.where;
        giveValue(element, attribute.defaultValue, element.constant ? "constant" : "attribute");
        into.attributes.push_back(std::move(attribute));
    } else if (element.kind == ElementKind::Operation) {
        into.operations.push_back(operationOf(element));
    }
}

const clang::FunctionDecl* Follower::unseenMaker(const Place& place) const {
    for (const auto& [object, constructor] : unseenObjects_) {
        if (place.compare(0, object.size() + 1, object + ".") == 0) return constructor;
    }
    return nullptr;
}

/// The value that the variable has at the end of the constructor.
void Follower::giveValue(const Element& element, model::Text& value, const std::string& what) {
    const auto found = memory_.find(element.value);
    const bool changed = memory_.count(element.value + "#changed") != 0;
    if (found == memory_.end() && !changed && unseenMaker(element.value) == nullptr) {
        if (element.constant) remarks_.warning(element.where, "OC024", "the value of this constant cannot be told");
        return;
    }
    const bool unseen = found == memory_.end() && unseenMaker(element.value) != nullptr;
    if (unseen) unseen_.insert(unseenMaker(element.value));
    const auto text = changed || found == memory_.end() ? std::nullopt : literal(found->second, element.valueType);
    if (!text) {
        remarks_.warning(element.where, "OC024", "the initial value of this " + what + " is not constant");
        return;
    }
    const bool isDefault = !element.constant && (*text == "0" || *text == "false" || text->empty());
    if (!isDefault) value = textAt(*text, element.where);
}

std::optional<std::string> Follower::literal(const Value& value, clang::QualType type) const {
    type = type.getNonReferenceType().getUnqualifiedType();
    if (value.is(Kind::Text)) return value.text;
    if (value.is(Kind::Cpp)) return value.text;
    if (type->isEnumeralType())
        return value.is(Kind::Number) && !value.text.empty() ? std::optional(value.text) : std::nullopt;
    const Value number = converted(value, type);
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

}  // namespace oroforge::cxx
