// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <charconv>

#include <clang/base/type_names.hpp>
#include <clang/types/cpp_type_text.hpp>

#include "evaluator.hpp"
#include "interface_calls.hpp"
#include "known_types.hpp"

namespace oroforge::cxx {

namespace {

using llvm::dyn_cast;
using Kind = Value::Kind;

constexpr std::array kTypes = {"data", "buffer", "circular_buffer"};
constexpr std::array kLocks = {"unsync", "locked", "lock_free"};

bool endsWith(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::optional<ElementKind> kindOf(const std::string& name) {
    if (name == "InputPort" || name == "OutputPort") return ElementKind::Port;
    if (name == "Property") return ElementKind::Property;
    if (name == "Attribute" || name == "Constant") return ElementKind::Attribute;
    if (name == "Operation") return ElementKind::Operation;
    if (name == "OperationCaller") return ElementKind::Caller;
    return std::nullopt;
}

}  // namespace

/// Returns a number as in a manifest. A float has fewer digits than the double that it is computed with.
model::Number numberOf(double value, const diag::Location& where) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {std::string(text.data(), end.ptr), value, where};
}

bool KnownObjects::construct(const Place& at, clang::QualType type, const clang::CXXConstructorDecl* constructor,
                             const Values& arguments, clang::SourceLocation where) {
    const auto* record = type->getAsCXXRecordDecl();
    const std::string name = record == nullptr ? "" : toolchainName(*record);
    if (name.empty()) return false;
    if (kindOf(name)) {
        constructElement(at, name, type, arguments, where);
    } else if (name == "TaskContext" || name == "Service" || name == "ServiceRequester") {
        constructScope(at, name, arguments, where);
    } else if (endsWith(name, "Activity")) {
        constructActivity(at, name, constructor, arguments, where);
    } else if (name == "ConnPolicy") {
        Value policy = Value::ofText("", Kind::Policy);
        policy.policy.type = "data";
        const auto number = [&](std::size_t i) {
            return i < arguments.size() ? memory_.load(arguments[i]) : Value::null();
        };
        const Value kind = number(0), lock = number(1);
        if (kind.is(Kind::Number) && kind.number >= 0 && kind.number < 3)
            policy.policy.type = kTypes.at(static_cast<std::size_t>(kind.number));
        if (lock.is(Kind::Number) && lock.number >= 0 && lock.number < 3)
            policy.policy.lock = kLocks.at(static_cast<std::size_t>(lock.number));
        policy.policy.where = findings_.locate(where);
        memory_.set(at, policy);
    }
    return true;
}

void KnownObjects::constructElement(const Place& at, const std::string& name, clang::QualType type,
                                    const Values& arguments, clang::SourceLocation where) {
    const auto argument = [&](std::size_t i) {
        return i < arguments.size() ? memory_.load(arguments[i]) : Value::null();
    };
    Element element;
    element.kind = *kindOf(name);
    element.where = findings_.locate(where);
    const clang::QualType of = firstArgument(type);
    if (of.isNull()) return;
    if (argument(0).is(Kind::Text)) element.name = argument(0).text;
    if (element.kind == ElementKind::Operation || element.kind == ElementKind::Caller) {
        const Value function = argument(1);
        describeFunction(element, function.is(Kind::Function) ? function.function : nullptr, of);
        for (std::size_t i = 1; i < arguments.size(); ++i) {
            if (endsWith(argument(i).text, "OwnThread")) element.own = true;
        }
        registry_.elements[at] = std::move(element);
        return;
    }
    element.type = cppTypeText(of.getUnqualifiedType(), context_);
    element.valueType = of;
    element.uses = {of};
    element.output = name == "OutputPort";
    element.constant = name == "Constant";
    if (name == "InputPort" && arguments.size() > 1) {
        bool known = !arguments[1].is(Kind::Null);
        const model::Policy policy = policyAt(arguments[1], known);
        if (known) element.policy = policy;
        if (!known && !arguments[1].is(Kind::Null))
            findings_.remark(where, "OC025", "the connection policy of this port is not constant");
    }
    const std::size_t valueAt = name == "Property" ? 2 : 1;
    if (element.kind == ElementKind::Property && argument(1).is(Kind::Text)) element.doc = argument(1).text;
    if (element.kind != ElementKind::Port) {
        element.value = at.of(Place::Kind::Held);
        if (valueAt < arguments.size() && !arguments[valueAt].is(Kind::Null)) {
            const Value& value = arguments[valueAt];
            if (value.is(Kind::Place)) memory_.copy(value.place, element.value);
            if (memory_.find(element.value) == nullptr && !memory_.load(value).is(Kind::Unknown))
                memory_.set(element.value, values_.converted(memory_.load(value), of));
        }
    }
    registry_.elements[at] = std::move(element);
}

void KnownObjects::constructScope(const Place& at, const std::string& name, const Values& arguments,
                                  clang::SourceLocation where) {
    const Value text = arguments.empty() ? Value() : memory_.load(arguments[0]);
    const std::string named = text.is(Kind::Text) ? text.text : "";
    if (name == "ServiceRequester") {
        registry_.requesters[at] = &registry_.makeRequester(named, findings_.locate(where));
        return;
    }
    registry_.scopes[at] = &registry_.makeScope(named, findings_.locate(where));
    if (name != "TaskContext" || !at.isComponent() || arguments.size() < 2) return;
    const Value initial = memory_.load(arguments[1]);
    if (endsWith(initial.text, "PreOperational")) {
        registry_.initial = model::InitialState::PreOperational;
    } else if (!endsWith(initial.text, "Stopped") && !initial.is(Kind::Null)) {
        findings_.remark(where, "OC025", "the initial state of the component is not constant");
    }
}

void KnownObjects::constructActivity(const Place& at, const std::string& name,
                                     const clang::CXXConstructorDecl* constructor, const Values& arguments,
                                     clang::SourceLocation where) {
    model::Activity activity;
    activity.where = findings_.locate(where);
    if (name == "SequentialActivity") activity.kind = model::ActivityKind::Sequential;
    if (name == "SlaveActivity") activity.kind = model::ActivityKind::Slave;
    const bool known =
        name == "Activity" || name == "PeriodicActivity" || name == "SequentialActivity" || name == "SlaveActivity";
    if (!known || constructor == nullptr) return;
    bool hasPriority = false;
    for (unsigned i = 0; i < constructor->getNumParams() && i < arguments.size(); ++i) {
        const llvm::StringRef parameter = constructor->getParamDecl(i)->getName();
        const Value value = memory_.load(arguments[i]);
        const bool isNumber = value.is(Kind::Number) || value.is(Kind::Real);
        const double number = value.is(Kind::Real) ? value.real : static_cast<double>(value.number);
        if (parameter == "master") return;
        if (parameter != "scheduler" && parameter != "priority" && parameter != "period") continue;
        if (value.is(Kind::Null)) continue;
        if (!isNumber) {
            findings_.remark(where, "OC025", "the " + parameter.str() + " of this activity is not constant");
        } else if (parameter == "scheduler") {
            activity.scheduler = {number == 0 ? "ORO_SCHED_OTHER" : "ORO_SCHED_RT", activity.where};
        } else if (parameter == "priority") {
            activity.priority = numberOf(number, activity.where);
            hasPriority = true;
        } else if (number > 0) {
            activity.period = numberOf(number, activity.where);
            if (activity.kind == model::ActivityKind::NonPeriodic) activity.kind = model::ActivityKind::Periodic;
        }
    }
    // A priority without a scheduler implies the real-time one.
    if (hasPriority && !activity.scheduler.given()) activity.scheduler = {"ORO_SCHED_RT", activity.where};
    registry_.activities[at] = activity;
}

void KnownObjects::describeFunction(Element& element, const clang::FunctionDecl* function,
                                    clang::QualType signature) const {
    const auto* type = signature.isNull() ? nullptr : signature->getAs<clang::FunctionProtoType>();
    if (type == nullptr) return;
    // The declaration has the user's words, unless the bound function has other arguments.
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

model::Policy KnownObjects::policyAt(const Value& value, bool& known) const {
    const Value whole = memory_.load(value);
    known = known && whole.is(Kind::Policy);
    model::Policy policy = whole.policy;
    if (!value.is(Kind::Place)) return policy;
    const auto part = [&](const char* field) { return memory_.find(value.place.field(field)); };
    for (const auto& [field, number] : {std::pair("type", part("type")), std::pair("size", part("size")),
                                        std::pair("lock_policy", part("lock_policy")), std::pair("init", part("init")),
                                        std::pair("pull", part("pull"))}) {
        if (number == nullptr) continue;
        if (!number->is(Kind::Number) && !number->is(Kind::Boolean)) known = false;
        const auto index = static_cast<std::size_t>(number->number);
        const std::string name = field;
        if (name == "type" && index < kTypes.size()) policy.type = kTypes.at(index);
        if (name == "lock_policy" && index < kLocks.size()) policy.lock = kLocks.at(index);
        if (name == "size") policy.size = numberOf(static_cast<double>(number->number), policy.where);
        if (name == "init") policy.init = number->number != 0;
        if (name == "pull") policy.pull = number->number != 0;
    }
    return policy;
}

Value KnownObjects::policyCall(const clang::CallExpr& expression, const std::string& name) {
    const Values arguments = calls_.argumentsOf(expression);
    Value made = Value::ofText("", Kind::Policy);
    model::Policy& policy = made.policy;
    policy.where = findings_.locate(expression.getBeginLoc());
    policy.type = name == "buffer" ? "buffer" : name == "circularBuffer" ? "circular_buffer" : "data";
    std::size_t next = 0;
    bool known = true;
    const auto take = [&] {
        const Value value = next < arguments.size() ? memory_.load(arguments[next]) : Value();
        ++next;
        known = known && (value.is(Kind::Number) || value.is(Kind::Boolean));
        return value.number;
    };
    if (policy.type != "data") policy.size = numberOf(static_cast<double>(take()), policy.where);
    const auto lock = static_cast<std::size_t>(take());
    if (lock < kLocks.size()) policy.lock = kLocks.at(lock);
    policy.init = take() != 0;
    policy.pull = take() != 0;
    return known ? made : Value();
}

}  // namespace oroforge::cxx
