// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <clang/base/type_names.hpp>
#include <clang/types/cpp_type_text.hpp>

#include "follow.hpp"

namespace oroforge::cxx {

namespace {

using llvm::dyn_cast;
using Kind = Value::Kind;

bool beginsWith(const std::string& text, const char* start) { return text.rfind(start, 0) == 0; }

/// The class of RTT's that a class is, or is derived from: InputPort<double> of a user's port class.
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

/// provides("x")->… rather than service->…
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

}  // namespace

bool Follower::isInterface(const clang::CXXMethodDecl& method) const {
    return !toolchainName(*method.getParent()).empty();
}

Element* Follower::elementAt(const Place& place) {
    const auto found = elements_.find(place);
    return found == elements_.end() ? nullptr : &found->second;
}

Scope* Follower::scopeAt(const Place& place) {
    const auto found = scopes_.find(place);
    return found == scopes_.end() ? nullptr : found->second;
}

bool Follower::named(const clang::CallExpr& expression) const {
    return expression.getNumArgs() != 0 && isStdString(expression.getArg(0)->getType());
}

bool Follower::certain(const clang::CallExpr& expression, const std::string& what) {
    if (undecided_.empty()) return true;
    remarks_.warning(locate(expression.getExprLoc()), "OC022",
                     what + " is added " + (late_.empty() ? undecided_.back() : late_));
    return false;
}

Place Follower::elementOf(const clang::Expr* expression, ElementKind kind) {
    const Value value = eval(expression);
    if (value.is(Kind::Place) && elementAt(value.text) != nullptr) return value.text;
    static const char* const ports[] = {"InputPort", "OutputPort"};
    static const char* const properties[] = {"Property"};
    static const char* const attributes[] = {"Attribute", "Constant"};
    static const char* const operations[] = {"Operation"};
    static const char* const callers[] = {"OperationCaller"};
    const llvm::ArrayRef<const char*> names = kind == ElementKind::Port        ? llvm::ArrayRef(ports)
                                              : kind == ElementKind::Property  ? llvm::ArrayRef(properties)
                                              : kind == ElementKind::Attribute ? llvm::ArrayRef(attributes)
                                              : kind == ElementKind::Operation ? llvm::ArrayRef(operations)
                                                                               : llvm::ArrayRef(callers);
    const clang::QualType type = knownBase(expression->IgnoreParenImpCasts()->getType(), names);
    if (type.isNull()) return {};
    const Place place = value.is(Kind::Place) ? value.text : fresh("object");
    constructElement(place, toolchainName(*type->getAsCXXRecordDecl()), type, {}, expression->getExprLoc());
    if (Element* made = elementAt(place); made != nullptr && !made->value.empty()) memory_[made->value] = Value();
    return elementAt(place) == nullptr ? Place() : place;
}

void Follower::add(const clang::CallExpr& expression, const std::string& what, const Place& place, Scope& scope) {
    Element* element = elementAt(place);
    const bool isNamed = named(expression);
    const auto name = isNamed ? textOf(expression.getArg(0)) : element != nullptr ? element->name : std::nullopt;
    const std::string shown = what + (name ? " '" + *name + "'" : "");
    const bool isThere = name && std::any_of(scope.elements.begin(), scope.elements.end(),
                                             [&](const Place& other) { return elements_[other].name == name; });
    if (!late_.empty() && isThere) return;
    hasMore_ |= (what == "port" || what == "property") && (!undecided_.empty() || element == nullptr || !name);
    if (!certain(expression, shown)) return;
    if (element == nullptr) {
        remark(expression.getExprLoc(), "OC021",
               "what is added as " + shown + " cannot be told: its type is not known");
        return;
    }
    if (!name) {
        remark(expression.getExprLoc(), "OC021", "the name of this " + what + " is not constant");
        return;
    }
    element->name = name;
    element->where = locate(isNamed ? expression.getArg(0)->getExprLoc() : expression.getExprLoc());
    const auto known = std::find_if(scope.elements.begin(), scope.elements.end(), [&](const Place& other) {
        const Element& old = elements_[other];
        return other == place || (old.kind == ElementKind::Port && old.kind == element->kind && old.name == name);
    });
    if (known != scope.elements.end()) scope.elements.erase(known);
    scope.elements.push_back(place);
}

Value Follower::addPort(const clang::CallExpr& expression, bool event, Scope& scope) {
    const clang::Expr* port = expression.getArg(named(expression) ? 1 : 0);
    const Place place = elementOf(port, ElementKind::Port);
    if (Element* element = elementAt(place); element != nullptr && undecided_.empty()) element->event = event;
    // Callbacks are functions of their own.
    add(expression, "port", place, scope);
    return place.empty() ? Value() : Value::ofPlace(place);
}

Value Follower::addProperty(const clang::CallExpr& expression, Scope& scope) {
    const clang::Expr* variable = expression.getArg(named(expression) ? 1 : 0);
    const clang::QualType type = variable->IgnoreParenImpCasts()->getType();
    static const char* const known[] = {"Property", "PropertyBase"};
    Place place;
    if (!knownBase(type->isPointerType() ? type->getPointeeType() : type, known).isNull()) {
        place = elementOf(variable, ElementKind::Property);
    } else {
        const Value value = eval(variable);
        place = fresh("property");
        Element made;
        made.kind = ElementKind::Property;
        made.valueType = variable->getType().getUnqualifiedType();
        made.type = cppTypeText(made.valueType, context_);
        made.uses = {made.valueType};
        made.value = value.is(Kind::Place) ? value.text : fresh("object");
        if (!value.is(Kind::Place)) memory_[made.value] = Value();
        elements_[place] = made;
    }
    add(expression, "property", place, scope);
    return place.empty() ? Value() : Value::ofPlace(place);
}

Value Follower::addAttribute(const clang::CallExpr& expression, bool constant, Scope& scope) {
    const clang::Expr* variable = expression.getArg(named(expression) ? 1 : 0);
    static const char* const known[] = {"Attribute", "Constant", "AttributeBase", "Alias"};
    const char* const what = constant ? "constant" : "attribute";
    Place place;
    const clang::QualType type = variable->IgnoreParenImpCasts()->getType();
    if (!knownBase(type->isPointerType() ? type->getPointeeType() : type, known).isNull()) {
        place = elementOf(variable, ElementKind::Attribute);
    } else {
        const Value value = eval(variable);
        place = fresh("attribute");
        Element made;
        made.kind = ElementKind::Attribute;
        made.constant = constant;
        made.valueType = variable->getType().getUnqualifiedType();
        made.type = cppTypeText(made.valueType, context_);
        made.uses = {made.valueType};
        made.value = value.is(Kind::Place) ? value.text : fresh("object");
        if (!value.is(Kind::Place)) memory_[made.value] = value;
        elements_[place] = made;
    }
    add(expression, what, place, scope);
    return place.empty() ? Value() : Value::ofPlace(place);
}

void Follower::describeFunction(Element& element, const clang::FunctionDecl* function,
                                clang::QualType signature) const {
    const auto* type = signature.isNull() ? nullptr : signature->getAs<clang::FunctionProtoType>();
    if (type == nullptr) return;
    // The declaration says it in the user's words; what is bound may have other arguments than the function.
    const bool same = function != nullptr && function->getNumParams() == type->getNumParams();
    const clang::QualType result = same ? function->getReturnType() : type->getReturnType();
    const bool isDeduced = result->getContainedAutoType() != nullptr;
    element.result = cppTypeText(isDeduced ? type->getReturnType() : result, context_);
    element.arguments.clear();
    element.uses = {type->getReturnType()};
    element.uses.insert(element.uses.end(), type->param_type_begin(), type->param_type_end());
    for (unsigned i = 0; i != type->getNumParams(); ++i) {
        model::Argument argument;
        argument.name.value = "arg" + std::to_string(i + 1);
        argument.type.value = cppTypeText(
            same ? function->getParamDecl(i)->getType().getUnqualifiedType() : type->getParamType(i), context_);
        element.arguments.push_back(argument);
    }
}

Value Follower::addOperation(const clang::CallExpr& expression, Scope& scope) {
    if (!named(expression)) {
        const Place place = elementOf(expression.getArg(0), ElementKind::Operation);
        add(expression, "operation", place, scope);
        return place.empty() ? Value() : Value::ofPlace(place);
    }
    const Place place = fresh("operation");
    Element made;
    made.kind = ElementKind::Operation;
    const clang::FunctionDecl* function = nullptr;
    for (unsigned i = 1; i < expression.getNumArgs(); ++i) {
        const Value direct = load(eval(expression.getArg(i)));
        if (direct.is(Kind::Function) && i == 1) function = direct.function;
        const auto* type = expression.getArg(i)->getType()->getAs<clang::EnumType>();
        if (type == nullptr || type->getDecl()->getName() != "ExecutionThread") continue;
        made.own = direct.text.find("OwnThread") != std::string::npos;
        if (!direct.is(Kind::Number))
            remark(expression.getArg(i)->getExprLoc(), "OC025", "the thread of this operation is not constant");
    }
    describeFunction(made, function, firstArgument(expression.getType()));
    if (!made.result.empty()) elements_[place] = made;
    add(expression, "operation", place, scope);
    return Value::ofPlace(place);
}

Value Follower::addCaller(const clang::CallExpr& expression, Requester& requester) {
    const Place place = elementOf(expression.getArg(0), ElementKind::Caller);
    const Element* caller = elementAt(place);
    const std::string name = caller != nullptr && caller->name ? " '" + *caller->name + "'" : "";
    if (!certain(expression, "operation caller" + name)) return {};
    if (caller == nullptr || !caller->name) {
        remark(expression.getExprLoc(), "OC021", "the name of this operation caller is not constant");
        return {};
    }
    requester.callers.push_back(place);
    return Value::ofBoolean(true);
}

Value Follower::addService(const clang::CallExpr& expression, Scope& scope) {
    const Value value = eval(expression.getArg(0));
    Scope* added = scopeAt(value.text);
    if (added == nullptr) added = scopeAt(load(value).text);
    hasMore_ |= added == nullptr || !undecided_.empty();  // whatever is in it
    if (!certain(expression, "service")) return {};
    if (added == nullptr) {
        remark(expression.getExprLoc(), "OC021", "which service this is cannot be told");
    } else if (std::find(scope.services.begin(), scope.services.end(), added) == scope.services.end()) {
        scope.services.push_back(added);
    }
    return Value::ofBoolean(true);
}

std::optional<Value> Follower::addCall(const clang::CallExpr& expression, const std::string& name, Scope& scope) {
    if (expression.getNumArgs() == 0) return std::nullopt;
    if (name == "addPort" || name == "addLocalPort") return addPort(expression, false, scope);
    if (name == "addEventPort" || name == "addLocalEventPort") return addPort(expression, true, scope);
    if (name == "addProperty" || (name == "add" && !named(expression)) || name == "ownProperty")
        return addProperty(expression, scope);
    if (name == "addAttribute" || name == "setValue") return addAttribute(expression, false, scope);
    if (name == "addConstant") return addAttribute(expression, true, scope);
    if (name == "addOperation" || name == "addSynchronousOperation" || name == "addEventOperation" ||
        name == "addOperationDS")
        return addOperation(expression, scope);
    if (name == "addService") return addService(expression, scope);
    return std::nullopt;
}

Value Follower::interfaceCall(const clang::CallExpr& expression, const clang::CXXMethodDecl& method,
                              const Place& object) {
    const std::string name = method.getNameAsString();
    const std::string owner = toolchainName(*method.getParent());
    if (owner == "Service" && name == "Create" && method.isStatic()) {
        const Values arguments = argumentsOf(expression, 0);
        const Place made = fresh("service");
        constructScope(made, "Service", arguments, expression.getExprLoc());
        Scope* outer = arguments.size() > 1 ? scopeAt(arguments[1].text) : nullptr;
        hasMore_ |= outer != nullptr && !undecided_.empty();
        if (outer != nullptr && certain(expression, "the service '" + scopes_[made]->name + "'"))
            outer->services.push_back(scopes_[made]);
        return Value::ofPlace(made);
    }
    if (owner == "ConnPolicy" && method.isStatic() && name != "Default") return policyCall(expression, name);
    if (Scope* scope = scopeAt(object)) {
        if (const auto value = addCall(expression, name, *scope)) return *value;
    }
    const auto requester = requesters_.find(object);
    if (name == "addOperationCaller" && requester != requesters_.end())
        return addCaller(expression, *requester->second);
    if (const auto value = elementCall(expression, name, object)) return *value;
    if (const auto value = serviceCall(expression, name, object)) return *value;
    if (const auto value = activityCall(expression, name, object)) return *value;
    // A variable for a service that the source does not tell. Of a call that gives one it was said already.
    if (scopeAt(object) == nullptr && beginsWith(name, "add") && !isGivenByCall(expression) &&
        (owner == "Service" || owner == "ConfigurationInterface" || owner == "DataFlowInterface" ||
         owner == "ServiceRequester")) {
        hasMore_ = true;
        remark(expression.getExprLoc(), "OC021", "where '" + name + "' adds this is not constant");
    }
    if (owner == "PropertyBag" && beginsWith(object, kRoot) && (beginsWith(name, "add") || name == "ownProperty"))
        remark(expression.getExprLoc(), "OC025", "what a property holds that is a bag is not told");
    for (const Value& value : argumentsOf(expression, 0)) {
        // What is passed by pointer or reference stays with RTT: ports that are connected, variables that are read.
        if (value.is(Kind::Place) && beginsWith(name, "read")) forget(value.text);
    }
    return {};
}

}  // namespace oroforge::cxx
