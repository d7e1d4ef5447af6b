// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <clang/base/parse_files.hpp>

#include "evaluator.hpp"
#include "interface_calls.hpp"
#include "known_types.hpp"

namespace oroforge::cxx {

Place ServiceCalls::serviceNamed(Scope& scope, const std::string& name, const clang::Expr& at) {
    Scope* found = nullptr;
    for (Scope* one : scope.services) {
        if (one->name == name) found = one;
    }
    if (found == nullptr) {
        found = &registry_.makeScope(name, findings_.locate(at.getExprLoc()));
        scope.services.push_back(found);
    }
    for (const auto& [place, one] : registry_.scopes) {
        if (one == found) return place;
    }
    const Place place = memory_.fresh();
    registry_.scopes[place] = found;
    return place;
}

Place ServiceCalls::requesterNamed(const std::string& name, const clang::Expr& at) {
    const Place place = Place::requester(name);
    if (registry_.requesters.count(place) == 0)
        registry_.requesters[place] = &registry_.makeRequester(name, findings_.locate(at.getExprLoc()));
    return place;
}

Value ServiceCalls::addRequester(const clang::CallExpr& expression) {
    const Value value = values_.eval(expression.getArg(0));
    auto found = registry_.requesters.find(value.place);
    if (found == registry_.requesters.end()) found = registry_.requesters.find(memory_.load(value).place);
    if (!findings_.isAdded(expression.getExprLoc(), "required service")) return {};
    if (found == registry_.requesters.end() || found->second->name.empty()) {
        findings_.remark(expression.getExprLoc(), "OC021", "which required service this is cannot be told");
        return {};
    }
    registry_.requesters[Place::requester(found->second->name)] = found->second;
    return Value::ofBoolean(true);
}

/// A component that configures or starts itself calls its own hook.
Value ServiceCalls::callHook(const std::string& name) {
    for (const clang::CXXRecordDecl* type = stack_.type(); type != nullptr;) {
        for (const clang::CXXMethodDecl* method : type->methods()) {
            const bool isHook = method->getDeclName().isIdentifier() && method->getName() == name;
            const clang::FunctionDecl* definition = isHook ? definitionOf(*method) : nullptr;
            if (definition != nullptr && !isLibrary(*definition))
                return calls_.invoke(*definition, {}, Place::component());
        }
        const bool hasBase = type->getNumBases() != 0;
        type = hasBase ? type->bases_begin()->getType()->getAsCXXRecordDecl() : nullptr;
        if (type != nullptr) type = type->getDefinition();
    }
    return {};
}

Value ServiceCalls::require(const clang::CallExpr& expression, const Place& object) {
    const bool isRequester = registry_.requesters.count(object) != 0;
    if (expression.getNumArgs() == 0) return Value::ofPlace(isRequester ? object : requesterNamed("this", expression));
    const auto wanted = values_.textOf(expression.getArg(0));
    if (!wanted) {
        findings_.remark(expression.getExprLoc(), "OC021", "the name of this required service is not constant");
        return {};
    }
    if (isRequester && object != Place::requester("this")) {
        findings_.remark(expression.getExprLoc(), "OC025",
                         "the service '" + *wanted + "' is required within another one, which a manifest cannot tell");
        return {};
    }
    const bool isKnown = registry_.requesters.count(Place::requester(*wanted)) != 0;
    if (!isKnown && !findings_.isAdded(expression.getExprLoc(), "the required service '" + *wanted + "'")) return {};
    return Value::ofPlace(requesterNamed(*wanted, expression));
}

Value ServiceCalls::provide(const clang::CallExpr& expression, const Place& object, Scope& scope) {
    const auto wanted = values_.textOf(expression.getArg(0));
    if (!wanted) {
        findings_.noteMore();
        findings_.remark(expression.getExprLoc(), "OC021", "the name of this service is not constant");
        return {};
    }
    if (*wanted == "this") return Value::ofPlace(object);
    const bool isKnown = std::any_of(scope.services.begin(), scope.services.end(),
                                     [&](const Scope* one) { return one->name == *wanted; });
    findings_.noteMore(!isKnown && !findings_.isCertain());
    if (!isKnown && !findings_.isAdded(expression.getExprLoc(), "the service '" + *wanted + "'")) return {};
    return Value::ofPlace(serviceNamed(scope, *wanted, expression));
}

Value ServiceCalls::findOrRemove(const clang::CallExpr& expression, bool removes, Scope& scope) {
    const auto wanted = values_.textOf(expression.getArg(0));
    const auto found = std::find_if(scope.elements.begin(), scope.elements.end(), [&](const Place& place) {
        return wanted && registry_.elements[place].name == wanted;
    });
    if (found == scope.elements.end()) return {};
    if (!removes) return Value::ofPlace(*found);
    if (findings_.isCertain()) {
        scope.elements.erase(found);
    } else {
        findings_.remark(expression.getExprLoc(), "OC022", "'" + *wanted + "' is taken away again " + findings_.why());
    }
    return {};
}

std::optional<Value> ServiceCalls::call(const clang::CallExpr& expression, const std::string& name,
                                        const Place& object) {
    static const std::set<std::string> same = {"ports", "operations", "attributes", "properties", "shared_from_this"};
    static const std::set<std::string> finds = {"getPort", "getProperty", "getAttribute", "getValue"};
    static const std::set<std::string> removes = {"removePort", "removeOperation", "removeAttribute", "removeLocalPort",
                                                  "removeValue"};
    Scope* scope = registry_.scopeAt(object);
    const bool isRequester = registry_.requesters.count(object) != 0;
    const unsigned count = expression.getNumArgs();
    if ((name == "requires" || name == "requires_") && (isRequester || (scope != nullptr && object.isComponent())))
        return require(expression, object);
    if (isRequester && name == "addServiceRequester" && count == 1) return addRequester(expression);
    if (scope == nullptr) return std::nullopt;
    if ((name == "loadService" || name == "getProvider") && count == 1) {
        const auto wanted = values_.textOf(expression.getArg(0));
        findings_.remark(
            expression.getExprLoc(), "OC025",
            "what the service " + (wanted ? "'" + *wanted + "' " : "") + "brings that is loaded here is not told");
        return Value();
    }
    if (object.isComponent() && (name == "configure" || name == "start") && count == 0) return callHook(name + "Hook");
    if (same.count(name) != 0 || (name == "provides" && count == 0)) return Value::ofPlace(object);
    if (count != 1) return std::nullopt;
    if (name == "provides") return provide(expression, object, *scope);
    if (name == "doc") {
        if (const auto text = values_.textOf(expression.getArg(0)); text && findings_.isCertain()) scope->doc = *text;
        return Value();
    }
    if (finds.count(name) != 0) return findOrRemove(expression, false, *scope);
    if (removes.count(name) != 0) return findOrRemove(expression, true, *scope);
    return std::nullopt;
}

}  // namespace oroforge::cxx
