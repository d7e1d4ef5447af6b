// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <clang/base/parse_files.hpp>

#include "follow.hpp"

namespace oroforge::cxx {

namespace {

using Kind = Value::Kind;

const char* shown(ElementKind kind) {
    switch (kind) {
        case ElementKind::Port: return "port";
        case ElementKind::Property: return "property";
        case ElementKind::Attribute: return "attribute";
        case ElementKind::Operation: return "operation";
        case ElementKind::Caller: return "operation caller";
    }
    return "";
}

}  // namespace

/// What is asked of a port, a property, an operation …
std::optional<Value> Follower::elementCall(const clang::CallExpr& expression, const std::string& name,
                                           const Place& object) {
    Element* element = elementAt(object);
    if (element == nullptr) return std::nullopt;
    const unsigned count = expression.getNumArgs();
    const Value self = Value::ofPlace(object);
    if ((name == "doc" || name == "setDescription" || name == "setName") && count == 1) {
        const auto text = textOf(expression.getArg(0));
        const bool isDoc = name != "setName";
        if (!undecided_.empty() || !text) {
            const std::string why = text ? "is set " + undecided_.back() : "is not constant";
            remark(expression.getExprLoc(), text ? "OC022" : "OC021",
                   std::string("the ") + (isDoc ? "documentation" : "name") + " of this " + shown(element->kind) + " " +
                       why);
        } else if (isDoc) {
            element->doc = *text;
        } else {
            element->name = text;
        }
        return self;
    }
    if (name == "arg" && count == 2) {
        const auto argument = textOf(expression.getArg(0)), doc = textOf(expression.getArg(1));
        const std::size_t at = element->documented++;
        if (!argument || !doc)
            remark(expression.getExprLoc(), "OC021", "the name or documentation of this argument is not constant");
        if (at >= element->arguments.size()) return self;
        if (argument) element->arguments[at].name.value = *argument;
        if (doc) element->arguments[at].doc = *doc;
        element->arguments[at].where = locate(expression.getArg(0)->getExprLoc());
        return self;
    }
    if (name == "calls") {
        for (const Value& value : argumentsOf(expression, 0)) {
            const Value argument = load(value);
            if (argument.text.find("OwnThread") != std::string::npos) element->own = true;
        }
        return self;
    }
    if (name == "signals" && count == 0) return self;
    if ((name == "set" || name == "value") && count == 0) return Value::ofPlace(element->value);
    if (name == "set" && count == 1 && !element->value.empty()) {
        const Value value = eval(expression.getArg(0));
        const bool isObject = value.is(Kind::Place) && memory_.count(value.text) == 0;
        if (isObject) forget(element->value);
        if (isObject) copyObject(value.text, element->value);
        if (!isObject) assign(element->value, converted(load(value), element->valueType));
        return Value();
    }
    if (name == "get" || name == "rvalue") return load(Value::ofPlace(element->value));
    return std::nullopt;
}

Place Follower::serviceNamed(Scope& scope, const std::string& name, const clang::Expr& at) {
    Scope* found = nullptr;
    for (Scope* one : scope.services) {
        if (one->name == name) found = one;
    }
    if (found == nullptr) {
        allScopes_.push_back(std::make_unique<Scope>());
        found = allScopes_.back().get();
        found->name = name;
        found->where = locate(at.getExprLoc());
        scope.services.push_back(found);
    }
    for (const auto& [place, one] : scopes_) {
        if (one == found) return place;
    }
    const Place place = fresh("service");
    scopes_[place] = found;
    return place;
}

Place Follower::requesterNamed(const std::string& name, const clang::Expr& at) {
    const Place place = "requester " + name;
    if (requesters_.count(place) == 0) {
        allRequesters_.push_back(std::make_unique<Requester>());
        allRequesters_.back()->name = name;
        allRequesters_.back()->where = locate(at.getExprLoc());
        requesters_[place] = allRequesters_.back().get();
    }
    return place;
}

Value Follower::addRequester(const clang::CallExpr& expression) {
    const Value value = eval(expression.getArg(0));
    auto found = requesters_.find(value.text);
    if (found == requesters_.end()) found = requesters_.find(load(value).text);
    if (!certain(expression, "required service")) return {};
    if (found == requesters_.end() || found->second->name.empty()) {
        remark(expression.getExprLoc(), "OC021", "which required service this is cannot be told");
        return {};
    }
    requesters_["requester " + found->second->name] = found->second;
    return Value::ofBoolean(true);
}

/// A component that configures or starts itself calls its own hook.
Value Follower::callHook(const std::string& name) {
    for (const clang::CXXRecordDecl* type = dynamic_; type != nullptr;) {
        for (const clang::CXXMethodDecl* method : type->methods()) {
            const bool isHook = method->getDeclName().isIdentifier() && method->getName() == name;
            const clang::FunctionDecl* definition = isHook ? definitionOf(*method) : nullptr;
            if (definition != nullptr && !isLibrary(*definition)) return invoke(*definition, {}, kRoot, false);
        }
        const bool hasBase = type->getNumBases() != 0;
        type = hasBase ? type->bases_begin()->getType()->getAsCXXRecordDecl() : nullptr;
        if (type != nullptr) type = type->getDefinition();
    }
    return {};
}

/// What is asked of the component or one of its services, or of what it requires.
std::optional<Value> Follower::serviceCall(const clang::CallExpr& expression, const std::string& name,
                                           const Place& object) {
    const bool requires_ = name == "requires" || name == "requires_";
    Scope* scope = scopeAt(object);
    const bool isRequester = requesters_.count(object) != 0;
    if (scope == nullptr && !isRequester) return std::nullopt;
    const unsigned count = expression.getNumArgs();
    if (requires_ && (isRequester || object == kRoot)) {
        if (count == 0)
            return isRequester ? Value::ofPlace(object) : Value::ofPlace(requesterNamed("this", expression));
        const auto wanted = textOf(expression.getArg(0));
        if (!wanted) {
            remark(expression.getExprLoc(), "OC021", "the name of this required service is not constant");
            return Value();
        }
        if (isRequester && object != "requester this") {
            remark(expression.getExprLoc(), "OC025",
                   "the service '" + *wanted + "' is required within another one, which a manifest cannot tell");
            return Value();
        }
        const bool isKnown = requesters_.count("requester " + *wanted) != 0;
        if (!isKnown && !certain(expression, "the required service '" + *wanted + "'")) return Value();
        return Value::ofPlace(requesterNamed(*wanted, expression));
    }
    if (isRequester && name == "addServiceRequester" && count == 1) return addRequester(expression);
    if (scope == nullptr) return std::nullopt;
    if ((name == "loadService" || name == "getProvider") && count == 1) {
        const auto wanted = textOf(expression.getArg(0));
        remark(expression.getExprLoc(), "OC025",
               "what the service " + (wanted ? "'" + *wanted + "' " : "") + "brings that is loaded here is not told");
        return Value();
    }
    if (object == kRoot && (name == "configure" || name == "start") && count == 0) return callHook(name + "Hook");
    if (name == "ports" || name == "operations" || name == "attributes" || name == "properties" ||
        (name == "provides" && count == 0) || name == "shared_from_this")
        return Value::ofPlace(object);
    if (name == "provides" && count == 1) {
        const auto wanted = textOf(expression.getArg(0));
        if (!wanted) {
            hasMore_ = true;
            remark(expression.getExprLoc(), "OC021", "the name of this service is not constant");
            return Value();
        }
        if (*wanted == "this") return Value::ofPlace(object);
        const bool isKnown = std::any_of(scope->services.begin(), scope->services.end(),
                                         [&](const Scope* one) { return one->name == *wanted; });
        hasMore_ |= !isKnown && !undecided_.empty();
        if (!isKnown && !certain(expression, "the service '" + *wanted + "'")) return Value();
        return Value::ofPlace(serviceNamed(*scope, *wanted, expression));
    }
    if (name == "doc" && count == 1) {
        if (const auto text = textOf(expression.getArg(0)); text && undecided_.empty()) scope->doc = *text;
        return Value();
    }
    const bool finds = name == "getPort" || name == "getProperty" || name == "getAttribute" || name == "getValue";
    const bool removes = name == "removePort" || name == "removeOperation" || name == "removeAttribute" ||
                         name == "removeLocalPort" || name == "removeValue";
    if ((finds || removes) && count == 1) {
        const auto wanted = textOf(expression.getArg(0));
        for (std::size_t i = 0; i != scope->elements.size() && wanted; ++i) {
            const Place place = scope->elements[i];
            if (elements_[place].name != wanted) continue;
            if (removes && !undecided_.empty()) {
                if (late_.empty())
                    remark(expression.getExprLoc(), "OC022",
                           "'" + *wanted + "' is taken away again " + undecided_.back());
                return Value();
            }
            if (removes) scope->elements.erase(scope->elements.begin() + static_cast<std::ptrdiff_t>(i));
            return finds ? Value::ofPlace(place) : Value();
        }
        return Value();
    }
    return std::nullopt;
}

void Follower::noteActivity(const clang::CallExpr& expression, std::optional<model::Activity> activity) {
    if (!undecided_.empty()) {
        remark(expression.getExprLoc(), "OC022", "the activity is set " + undecided_.back());
    } else if (!activity) {
        remark(expression.getExprLoc(), "OC025", "this activity is none that a manifest can tell");
    } else {
        activity_ = std::move(activity);
    }
}

std::optional<Value> Follower::activityCall(const clang::CallExpr& expression, const std::string& name,
                                            const Place& object) {
    const std::string own = std::string(kRoot) + "#activity";
    if (object == kRoot && name == "getActivity") return Value::ofPlace(own);
    if (object == kRoot && (name == "setActivity" || name == "forceActivity")) {
        const Value value = eval(expression.getArg(0));
        const auto known = activities_.find(value.is(Kind::Place) ? value.text : "");
        const auto loaded = activities_.find(load(value).text);
        const auto found = known != activities_.end() ? known : loaded;
        noteActivity(expression, found == activities_.end() ? std::nullopt : std::optional(found->second));
        return Value();
    }
    const auto activity = activities_.find(object);
    if (name != "setPeriod" || (object != kRoot && object != own && activity == activities_.end())) return std::nullopt;
    const Value value = content(expression.getArg(0));
    const bool known = value.is(Kind::Real) || value.is(Kind::Number);
    const double period = value.is(Kind::Real) ? value.real : static_cast<double>(value.number);
    model::Activity changed;
    if (activity != activities_.end()) changed = activity->second;
    if (activity == activities_.end() && activity_) changed = *activity_;
    changed.where = locate(expression.getExprLoc());
    changed.period.reset();
    if (period > 0)
        changed.period = model::Number{*literal(Value::ofReal(period), context_.DoubleTy), period, changed.where};
    if (changed.kind == model::ActivityKind::NonPeriodic && period > 0) changed.kind = model::ActivityKind::Periodic;
    if (changed.kind == model::ActivityKind::Periodic && !(period > 0)) changed.kind = model::ActivityKind::NonPeriodic;
    if (!known) {
        remark(expression.getExprLoc(), "OC025", "the period of this activity is not constant");
    } else if (activity != activities_.end()) {
        activity->second = changed;
    } else {
        noteActivity(expression, changed);
    }
    return Value();
}

}  // namespace oroforge::cxx
