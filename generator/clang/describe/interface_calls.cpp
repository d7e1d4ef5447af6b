// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <clang/base/type_names.hpp>
#include <clang/types/cpp_type_text.hpp>

#include "evaluator.hpp"
#include "interface_calls.hpp"
#include "known_types.hpp"

namespace oroforge::cxx {

namespace {

using llvm::dyn_cast;
using Kind = Value::Kind;

bool beginsWith(const std::string& text, const char* start) { return text.rfind(start, 0) == 0; }

/// Returns the RTT class that a class is or is derived from: InputPort<double> for a user's port class.
clang::QualType knownBase(clang::QualType type, llvm::ArrayRef<const char*> names) {
    type = type.getNonReferenceType();
    const auto* record = type->getAsCXXRecordDecl();
    if (record == nullptr || !record->hasDefinition()) return {};
    if (std::find(names.begin(), names.end(), toolchainName(*record)) != names.end()) return type;
    for (const clang::CXXBaseSpecifier& base : record->getDefinition()->bases()) {
        const clang::QualType found = knownBase(base.getType(), names);
        if (!found.isNull()) return found;
    }
    return {};
}

/// True for provides("x")->…, false for service->…
bool isGivenByCall(const clang::CallExpr& expression) {
    const auto* member = dyn_cast<clang::CXXMemberCallExpr>(&expression);
    const clang::Expr* object = member == nullptr ? nullptr : member->getImplicitObjectArgument();
    while (object != nullptr) {
        object = object->IgnoreParenImpCasts();
        if (const auto* arrow = dyn_cast<clang::CXXOperatorCallExpr>(object)) {
            object = arrow->getArg(0);
        } else if (const auto* temporary = dyn_cast<clang::MaterializeTemporaryExpr>(object)) {
            object = temporary->getSubExpr();
        } else if (const auto* bound = dyn_cast<clang::CXXBindTemporaryExpr>(object)) {
            object = bound->getSubExpr();
        } else {
            return llvm::isa<clang::CallExpr>(object);
        }
    }
    return false;
}

bool named(const clang::CallExpr& expression) {
    return expression.getNumArgs() != 0 && isStdString(expression.getArg(0)->getType());
}

Value valueOf(const Place& place) { return place.empty() ? Value() : Value::ofPlace(place); }

}  // namespace

Place InterfaceCalls::elementOf(const clang::Expr* expression, ElementKind kind) {
    const Value value = values_.eval(expression);
    if (value.is(Kind::Place) && registry_.elementAt(value.place) != nullptr) return value.place;
    static const std::map<ElementKind, std::vector<const char*>> names = {
        {ElementKind::Port, {"InputPort", "OutputPort"}},
        {ElementKind::Property, {"Property"}},
        {ElementKind::Attribute, {"Attribute", "Constant"}},
        {ElementKind::Operation, {"Operation"}},
        {ElementKind::Caller, {"OperationCaller"}}};
    const clang::QualType type = knownBase(expression->IgnoreParenImpCasts()->getType(), names.at(kind));
    if (type.isNull()) return {};
    const Place place = value.is(Kind::Place) ? value.place : memory_.fresh();
    known_.constructElement(place, toolchainName(*type->getAsCXXRecordDecl()), type, {}, expression->getExprLoc());
    if (Element* made = registry_.elementAt(place); made != nullptr && !made->value.empty())
        memory_.set(made->value, Value());
    return registry_.elementAt(place) == nullptr ? Place() : place;
}

Value InterfaceCalls::add(const clang::CallExpr& expression, const std::string& what, const Place& place,
                          Scope& scope) {
    Element* element = registry_.elementAt(place);
    const bool isNamed = named(expression);
    const auto name = isNamed              ? values_.textOf(expression.getArg(0))
                      : element != nullptr ? element->name
                                           : std::nullopt;
    const std::string shown = what + (name ? " '" + *name + "'" : "");
    const bool isThere = name && std::any_of(scope.elements.begin(), scope.elements.end(), [&](const Place& other) {
                             return registry_.elements[other].name == name;
                         });
    if (findings_.isLate() && isThere) return valueOf(place);
    findings_.noteMore((what == "port" || what == "property") &&
                       (!findings_.isCertain() || element == nullptr || !name));
    if (!findings_.isAdded(expression.getExprLoc(), shown)) return valueOf(place);
    if (element == nullptr) {
        findings_.remark(expression.getExprLoc(), "OC021",
                         "what is added as " + shown + " cannot be told: its type is not known");
        return valueOf(place);
    }
    if (!name) {
        findings_.remark(expression.getExprLoc(), "OC021", "the name of this " + what + " is not constant");
        return valueOf(place);
    }
    element->name = name;
    element->where = findings_.locate(isNamed ? expression.getArg(0)->getExprLoc() : expression.getExprLoc());
    const auto known = std::find_if(scope.elements.begin(), scope.elements.end(), [&](const Place& other) {
        const Element& old = registry_.elements[other];
        return other == place || (old.kind == ElementKind::Port && old.kind == element->kind && old.name == name);
    });
    if (known != scope.elements.end()) scope.elements.erase(known);
    scope.elements.push_back(place);
    return valueOf(place);
}

Value InterfaceCalls::addPort(const clang::CallExpr& expression, bool event, Scope& scope) {
    const clang::Expr* port = expression.getArg(named(expression) ? 1 : 0);
    const Place place = elementOf(port, ElementKind::Port);
    if (Element* element = registry_.elementAt(place); element != nullptr && findings_.isCertain())
        element->event = event;
    // The callback is followed as a function of its own.
    return add(expression, "port", place, scope);
}

Value InterfaceCalls::addVariable(const clang::CallExpr& expression, ElementKind kind, const std::string& what,
                                  Scope& scope) {
    static const char* const properties[] = {"Property", "PropertyBase"};
    static const char* const attributes[] = {"Attribute", "Constant", "AttributeBase", "Alias"};
    const bool isProperty = kind == ElementKind::Property;
    const clang::Expr* variable = expression.getArg(named(expression) ? 1 : 0);
    const clang::QualType type = variable->IgnoreParenImpCasts()->getType();
    if (!knownBase(type->isPointerType() ? type->getPointeeType() : type,
                   isProperty ? llvm::ArrayRef(properties) : llvm::ArrayRef(attributes))
             .isNull())
        return add(expression, what, elementOf(variable, kind), scope);
    const Value value = values_.eval(variable);
    Element made;
    made.kind = kind;
    made.constant = what == "constant";
    made.valueType = variable->getType().getUnqualifiedType();
    made.type = cppTypeText(made.valueType, context_);
    made.uses = {made.valueType};
    made.value = value.is(Kind::Place) ? value.place : memory_.fresh();
    if (!value.is(Kind::Place)) memory_.set(made.value, isProperty ? Value() : value);
    const Place place = memory_.fresh();
    registry_.elements[place] = made;
    return add(expression, what, place, scope);
}

Value InterfaceCalls::addOperation(const clang::CallExpr& expression, Scope& scope) {
    if (!named(expression))
        return add(expression, "operation", elementOf(expression.getArg(0), ElementKind::Operation), scope);
    const Place place = memory_.fresh();
    Element made;
    made.kind = ElementKind::Operation;
    const clang::FunctionDecl* function = nullptr;
    for (unsigned i = 1; i < expression.getNumArgs(); ++i) {
        const Value direct = memory_.load(values_.eval(expression.getArg(i)));
        if (direct.is(Kind::Function) && i == 1) function = direct.function;
        const auto* type = expression.getArg(i)->getType()->getAs<clang::EnumType>();
        if (type == nullptr || type->getDecl()->getName() != "ExecutionThread") continue;
        made.own = direct.text.find("OwnThread") != std::string::npos;
        if (!direct.is(Kind::Number))
            findings_.remark(expression.getArg(i)->getExprLoc(), "OC025",
                             "the thread of this operation is not constant");
    }
    known_.describeFunction(made, function, firstArgument(expression.getType()));
    if (!made.result.empty()) registry_.elements[place] = made;
    return add(expression, "operation", place, scope);
}

Value InterfaceCalls::addCaller(const clang::CallExpr& expression, Requester& requester) {
    const Place place = elementOf(expression.getArg(0), ElementKind::Caller);
    const Element* caller = registry_.elementAt(place);
    const std::string name = caller != nullptr && caller->name ? " '" + *caller->name + "'" : "";
    if (!findings_.isAdded(expression.getExprLoc(), "operation caller" + name)) return {};
    if (caller == nullptr || !caller->name) {
        findings_.remark(expression.getExprLoc(), "OC021", "the name of this operation caller is not constant");
        return {};
    }
    requester.callers.push_back(place);
    return Value::ofBoolean(true);
}

Value InterfaceCalls::addService(const clang::CallExpr& expression, Scope& scope) {
    const Value value = values_.eval(expression.getArg(0));
    Scope* added = registry_.scopeAt(value.place);
    if (added == nullptr) added = registry_.scopeAt(memory_.load(value).place);
    findings_.noteMore(added == nullptr || !findings_.isCertain());  // for all that it contains
    if (!findings_.isAdded(expression.getExprLoc(), "service")) return {};
    if (added == nullptr) {
        findings_.remark(expression.getExprLoc(), "OC021", "which service this is cannot be told");
    } else if (std::find(scope.services.begin(), scope.services.end(), added) == scope.services.end()) {
        scope.services.push_back(added);
    }
    return Value::ofBoolean(true);
}

std::optional<Value> InterfaceCalls::addCall(const clang::CallExpr& expression, const std::string& name, Scope& scope) {
    if (expression.getNumArgs() == 0) return std::nullopt;
    if (name == "addPort" || name == "addLocalPort") return addPort(expression, false, scope);
    if (name == "addEventPort" || name == "addLocalEventPort") return addPort(expression, true, scope);
    if (name == "addProperty" || (name == "add" && !named(expression)) || name == "ownProperty")
        return addVariable(expression, ElementKind::Property, "property", scope);
    if (name == "addAttribute" || name == "setValue")
        return addVariable(expression, ElementKind::Attribute, "attribute", scope);
    if (name == "addConstant") return addVariable(expression, ElementKind::Attribute, "constant", scope);
    if (name == "addOperation" || name == "addSynchronousOperation" || name == "addEventOperation" ||
        name == "addOperationDS")
        return addOperation(expression, scope);
    if (name == "addService") return addService(expression, scope);
    return std::nullopt;
}

Value InterfaceCalls::createService(const clang::CallExpr& expression) {
    const Values arguments = calls_.argumentsOf(expression);
    const Place made = memory_.fresh();
    known_.constructScope(made, "Service", arguments, expression.getExprLoc());
    Scope* outer = arguments.size() > 1 ? registry_.scopeAt(arguments[1].place) : nullptr;
    findings_.noteMore(outer != nullptr && !findings_.isCertain());
    if (outer != nullptr &&
        findings_.isAdded(expression.getExprLoc(), "the service '" + registry_.scopes[made]->name + "'"))
        outer->services.push_back(registry_.scopes[made]);
    return Value::ofPlace(made);
}

Value InterfaceCalls::call(const clang::CallExpr& expression, const clang::CXXMethodDecl& method, const Place& object) {
    const std::string name = method.getNameAsString();
    const std::string owner = toolchainName(*method.getParent());
    if (owner == "Service" && name == "Create" && method.isStatic()) return createService(expression);
    if (owner == "ConnPolicy" && method.isStatic() && name != "Default") return known_.policyCall(expression, name);
    if (Scope* scope = registry_.scopeAt(object)) {
        if (const auto value = addCall(expression, name, *scope)) return *value;
    }
    const auto requester = registry_.requesters.find(object);
    if (name == "addOperationCaller" && requester != registry_.requesters.end())
        return addCaller(expression, *requester->second);
    if (const auto value = elements_.call(expression, name, object)) return *value;
    if (const auto value = services_.call(expression, name, object)) return *value;
    if (const auto value = activities_.call(expression, name, object)) return *value;
    // The service in a variable is not known. For a call that returns one, this was reported already.
    if (registry_.scopeAt(object) == nullptr && beginsWith(name, "add") && !isGivenByCall(expression) &&
        (owner == "Service" || owner == "ConfigurationInterface" || owner == "DataFlowInterface" ||
         owner == "ServiceRequester")) {
        findings_.noteMore();
        findings_.remark(expression.getExprLoc(), "OC021", "where '" + name + "' adds this is not constant");
    }
    if (owner == "PropertyBag" && object.isOf(Place::Kind::Component) &&
        (beginsWith(name, "add") || name == "ownProperty"))
        findings_.remark(expression.getExprLoc(), "OC025", "what a property holds that is a bag is not told");
    for (const Value& value : calls_.argumentsOf(expression)) {
        // RTT keeps arguments passed by pointer or reference: connected ports, variables that are read.
        if (value.is(Kind::Place) && beginsWith(name, "read")) memory_.forget(value.place);
    }
    return {};
}

}  // namespace oroforge::cxx
