// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <array>

#include <clang/base/parse_files.hpp>
#include <clang/base/type_names.hpp>
#include <clang/types/cpp_type_text.hpp>

#include "evaluator.hpp"
#include "interface_calls.hpp"
#include "known_types.hpp"

namespace oroforge::cxx {

namespace {

using llvm::dyn_cast;
using Kind = Value::Kind;

template <std::size_t N>
bool isOneOf(llvm::StringRef name, const std::array<const char*, N>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool isLambda(const clang::FunctionDecl& function) {
    const auto* method = dyn_cast<clang::CXXMethodDecl>(&function);
    return method != nullptr && method->getParent()->isLambda();
}

}  // namespace

Values Calls::argumentsOf(const clang::CallExpr& expression, unsigned first) {
    Values values;
    for (unsigned i = first; i < expression.getNumArgs(); ++i) values.push_back(values_.eval(expression.getArg(i)));
    return values;
}

CallStack::Frame Calls::frameOf(const clang::FunctionDecl& function, const Values& arguments, const Place& self) {
    CallStack::Frame frame;
    frame.self = self;
    for (unsigned i = 0; i != function.getNumParams(); ++i) {
        const clang::ParmVarDecl* parameter = function.getParamDecl(i);
        const Value value = i < arguments.size() ? arguments[i] : Value();
        const bool isObject = parameter->getType()->isReferenceType() ||
                              (parameter->getType()->isRecordType() && !isPointerLike(parameter->getType()));
        Place& place = frame.locals[parameter];
        place = isObject && value.is(Kind::Place) ? value.place : memory_.fresh();
        if (!isObject || !value.is(Kind::Place)) memory_.set(place, value);
    }
    return frame;
}

Value Calls::invoke(const clang::FunctionDecl& function, const Values& arguments, const Place& self, bool lambda) {
    if (stack_.isTooDeep(function.getLocation())) return {};
    invoked_.insert(&function);
    CallStack::Frame frame = frameOf(function, arguments, self);
    frame.lambda = lambda;
    stack_.enter(std::move(frame));
    statements_.run(function.getBody());
    return stack_.leave();
}

bool Calls::isInvoked(const clang::FunctionDecl& function) const {
    const clang::FunctionTemplateDecl* pattern = function.getDescribedFunctionTemplate();
    return invoked_.count(&function) != 0 ||
           (pattern != nullptr && std::any_of(pattern->spec_begin(), pattern->spec_end(),
                                              [&](const auto* one) { return invoked_.count(one) != 0; }));
}

Value Calls::callUser(const clang::CallExpr& expression, const clang::FunctionDecl& function, const Place& self,
                      unsigned firstArgument) {
    const clang::FunctionDecl* definition = definitionOf(function);
    if (definition == nullptr || isLibrary(*definition)) return unknownCall(expression, &function, firstArgument);
    return invoke(*definition, argumentsOf(expression, firstArgument), self, isLambda(*definition));
}

/// Forgets variables that the call may change. A user's function that gets the component may do anything to it.
Value Calls::unknownCall(const clang::CallExpr& expression, const clang::FunctionDecl* function,
                         unsigned firstArgument) {
    bool getsComponent = false;
    for (unsigned i = firstArgument; i < expression.getNumArgs(); ++i) {
        const clang::Expr* argument = expression.getArg(i);
        const Value value = values_.eval(argument);
        if (!value.is(Kind::Place)) continue;
        if (registry_.scopes.count(value.place) != 0) {
            getsComponent = true;
            continue;
        }
        const clang::QualType type = argument->getType();
        const bool changes = type->isPointerType() ? !type->getPointeeType().isConstQualified()
                                                   : argument->isGLValue() && !type.isConstQualified();
        const bool isElement = registry_.elements.count(value.place) != 0;
        if (changes && !isElement) memory_.forget(value.place);
    }
    const bool isUsers = function != nullptr && !isLibrary(*function) && function->getBuiltinID() == 0;
    if (getsComponent && isUsers) {
        findings_.noteUnseen(*function);
        if (definitionOf(*function) == nullptr) {
            findings_.noteMore(!findings_.isLate());
            findings_
                .remark(expression.getBeginLoc(), "OC023",
                        "'" + function->getNameAsString() +
                            "' gets the component, and its definition is in none of the files")
                .note(findings_.locate(function->getLocation()), "declared here");
        }
    }
    return {};
}

Value Calls::call(const clang::CallExpr& expression) {
    if (const auto* one = dyn_cast<clang::CXXOperatorCallExpr>(&expression)) return operatorCall(*one);
    if (const auto* one = dyn_cast<clang::CXXMemberCallExpr>(&expression)) return memberCall(*one);
    const clang::FunctionDecl* function = expression.getDirectCallee();
    if (function == nullptr) {
        const Value callee = memory_.load(values_.eval(expression.getCallee()));
        function = callee.is(Kind::Function) ? callee.function : nullptr;
    }
    if (function == nullptr) return unknownCall(expression, nullptr, 0);
    if (const auto* method = dyn_cast<clang::CXXMethodDecl>(function);
        method != nullptr && method->isStatic() && !toolchainName(*method->getParent()).empty())
        return interface_.call(expression, *method, {});
    if (const auto value = standardCall(expression, *function)) return *value;
    return callUser(expression, *function, stack_.top().self);
}

std::optional<Value> Calls::standardCall(const clang::CallExpr& expression, const clang::FunctionDecl& function) {
    const bool standard = isStandard(function), boosted = outermostNamespace(function) == "boost";
    if (!standard && !boosted) return std::nullopt;
    const std::string name = function.getNameAsString();
    static const std::array made = {"make_unique", "make_shared", "make_intrusive"};
    if (isOneOf(name, made))
        return objects_.make(firstArgument(expression.getType()), argumentsOf(expression), expression.getBeginLoc());
    if (name == "get" && expression.getNumArgs() == 1) {
        const Value pair = values_.eval(expression.getArg(0));
        const auto* arguments = function.getTemplateSpecializationArgs();
        const auto* record = expression.getArg(0)->getType()->getAsCXXRecordDecl();
        if (!pair.is(Kind::Place) || arguments == nullptr || record == nullptr || !isStandard(*record, "pair") ||
            arguments->get(0).getKind() != clang::TemplateArgument::Integral)
            return Value();
        return Value::ofPlace(pair.place.field(arguments->get(0).getAsIntegral() == 0 ? "first" : "second"));
    }
    static const std::array same = {"move",      "forward",  "ref",  "cref",
                                    "addressof", "as_const", "data", "static_pointer_cast"};
    static const std::array ends = {"begin", "cbegin", "end", "cend"};
    if (isOneOf(name, ends) && expression.getNumArgs() == 1) return containers_.endOf(expression, name);
    if (name == "for_each" && expression.getNumArgs() == 3) return containers_.eachOf(expression);
    if (name == "lexical_cast" && isStdString(expression.getType())) return texts_.printed(*expression.getArg(0));
    if (name == "to_string" && expression.getNumArgs() == 1) {
        const Value value = values_.converted(values_.eval(expression.getArg(0)), expression.getArg(0)->getType());
        if (value.is(Kind::Number)) {
            const bool isSigned = expression.getArg(0)->getType()->isSignedIntegerOrEnumerationType();
            return Value::ofText(isSigned ? std::to_string(value.number)
                                          : std::to_string(static_cast<unsigned long long>(value.number)));
        }
        return value.is(Kind::Real) ? Value::ofText(std::to_string(value.real)) : Value();
    }
    if (name == "size" && expression.getNumArgs() == 1) {
        if (const auto* array = context_.getAsConstantArrayType(expression.getArg(0)->getType()))
            return Value::ofNumber(static_cast<long long>(array->getSize().getZExtValue()));
    }
    if (isOneOf(name, same) && expression.getNumArgs() == 1) return values_.eval(expression.getArg(0));
    return std::nullopt;
}

Value Calls::operatorCall(const clang::CXXOperatorCallExpr& expression) {
    const auto kind = expression.getOperator();
    const clang::Expr* first = expression.getArg(0);
    const clang::Expr* second = expression.getNumArgs() > 1 ? expression.getArg(1) : nullptr;
    const auto* function = expression.getDirectCallee();
    if ((kind == clang::OO_Arrow || kind == clang::OO_Star) && second == nullptr && isPointerLike(first->getType())) {
        const Value target = values_.pointed(first);
        return target.is(Kind::Place) ? target : Value();
    }
    if (const auto value = containers_.operate(expression)) return *value;
    if (kind == clang::OO_Call) {
        const Value callee = memory_.load(values_.eval(first));
        const clang::FunctionDecl* called = callee.is(Kind::Function) ? callee.function : nullptr;
        // The operator of a generic lambda is known only from its call.
        if (function != nullptr && isLambda(*function)) called = function;
        if (called != nullptr) return callUser(expression, *called, stack_.top().self, 1);
    }
    if (kind == clang::OO_Subscript && second != nullptr) {
        const Value base = values_.eval(first), index = values_.content(second);
        if (base.is(Kind::Place) && index.is(Kind::Number)) return Value::ofPlace(base.place.element(index.number));
        if (base.is(Kind::Place) && index.is(Kind::Text)) return Value::ofPlace(base.place.key(index.text));
        return {};
    }
    if (const auto value = texts_.operate(expression)) return *value;
    if (kind == clang::OO_Equal && second != nullptr) {
        const Value target = values_.eval(first), source = values_.eval(second);
        if (!target.is(Kind::Place)) return {};
        if (Element* element = registry_.elementAt(target.place); element != nullptr && !element->value.empty()) {
            memory_.assign(element->value, values_.converted(memory_.load(source), element->valueType));
        } else if (isPointerLike(first->getType())) {
            memory_.assign(target.place, second->isGLValue() ? memory_.load(source) : source);
        } else if (source.is(Kind::Place) && registry_.elements.count(target.place) == 0) {
            memory_.forget(target.place);
            memory_.erase(target.place.of(Place::Kind::Changed));  // it is a copy of the other now
            memory_.copy(source.place, target.place);
        } else {
            memory_.forget(target.place);
        }
        return target;
    }
    if (kind == clang::OO_LessLess && second != nullptr) {
        const Value target = values_.eval(first);
        // Other streams have no part in the interface.
        if (target.is(Kind::Place)) texts_.stream(target.place, *second);
        return target;
    }
    if (const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(function)) {
        const Value object = values_.eval(first);
        if (object.is(Kind::Place) && !isLibrary(*method)) return callUser(expression, *method, object.place, 1);
        if (object.is(Kind::Place) && !method->isConst()) memory_.forget(object.place);
        return {};
    }
    return function != nullptr ? callUser(expression, *function, stack_.top().self) : Value();
}

Value Calls::memberCall(const clang::CXXMemberCallExpr& expression) {
    const clang::CXXMethodDecl* method = expression.getMethodDecl();
    const clang::Expr* on = expression.getImplicitObjectArgument();
    if (method == nullptr || on == nullptr) return unknownCall(expression, nullptr, 0);
    const std::string name = method->getNameAsString();
    const Value object = values_.eval(on);
    const clang::QualType type = on->getType()->isPointerType() ? on->getType()->getPointeeType() : on->getType();
    if (const auto value = texts_.call(expression, name, object)) return *value;
    if (const auto value = containers_.call(expression, name, object)) return *value;
    if (isPointerLike(type)) {
        if (name == "get") return memory_.load(object);
        if (name == "reset" && object.is(Kind::Place)) {
            memory_.assign(object.place,
                           expression.getNumArgs() == 1 ? values_.eval(expression.getArg(0)) : Value::null());
            return {};
        }
    }
    if (!toolchainName(*method->getParent()).empty())
        return interface_.call(expression, *method, object.is(Kind::Place) ? object.place : Place());
    if (isStandard(*method->getParent(), "array") && (name == "size" || name == "at")) {
        const auto* instance = dyn_cast<clang::ClassTemplateSpecializationDecl>(method->getParent());
        if (name == "size" && instance != nullptr)
            return Value::ofNumber(instance->getTemplateArgs()[1].getAsIntegral().getExtValue());
        const Value index = values_.content(expression.getArg(0));
        if (object.is(Kind::Place) && index.is(Kind::Number)) return Value::ofPlace(object.place.element(index.number));
    }
    if (isLibrary(*method)) {
        if (object.is(Kind::Place) && !method->isConst()) memory_.forget(object.place);
        argumentsOf(expression);
        return {};
    }
    const auto* callee = dyn_cast<clang::MemberExpr>(expression.getCallee()->IgnoreParens());
    const bool qualified = callee != nullptr && callee->hasQualifier();
    const Place self = object.is(Kind::Place) ? object.place : memory_.fresh();
    const clang::CXXMethodDecl& called = qualified ? *method : stack_.overriderOf(*method, self);
    if (definitionOf(called) == nullptr && self.isComponent() && !called.isPureVirtual()) {
        findings_.noteUnseen(called);
        findings_.noteMore(!findings_.isLate());
        findings_
            .remark(expression.getExprLoc(), "OC023",
                    "'" + name + "' is called while the component is made, and its definition is in none of the files")
            .note(findings_.locate(called.getLocation()), "declared here");
        return {};
    }
    return callUser(expression, called, self);
}

}  // namespace oroforge::cxx
