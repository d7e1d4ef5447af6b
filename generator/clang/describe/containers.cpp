// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The value of an iterator is the place of an element.
#include <clang/base/type_names.hpp>
#include <clang/types/cpp_type_text.hpp>

#include "evaluator.hpp"
#include "known_types.hpp"

namespace oroforge::cxx {

namespace {

using Kind = Value::Kind;

constexpr long long kMostElements = 1000;

/// True if the value can be an iterator: the place of an element.
bool hasPosition(const Value& value) {
    constexpr long long most = 999999999;
    return value.is(Kind::Place) && !value.place.empty() && value.place.kind() == Place::Kind::Element &&
           value.place.index() >= 0 && value.place.index() <= most;
}

Value moved(const Value& iterator, long long by) {
    if (!hasPosition(iterator) || iterator.place.index() + by < 0) return {};
    return Value::ofPlace(iterator.place.whole().element(iterator.place.index() + by));
}

bool isIterator(clang::QualType type) {
    const auto* record = type.getNonReferenceType()->getAsCXXRecordDecl();
    if (record == nullptr || !isPointerLike(type)) return false;
    return record->getName().ends_with("iterator");
}

}  // namespace

/// Makes an empty container, or one with a number of equal elements; lists in braces are copied.
void Containers::construct(const Place& at, const Values& arguments) {
    const bool isEmpty = arguments.empty() || arguments[0].is(Kind::Null);
    const Value size = isEmpty ? Value::ofNumber(0) : memory_.load(arguments[0]);
    if (!size.is(Kind::Number) || size.number < 0 || size.number > kMostElements) return;
    memory_.set(at.of(Place::Kind::Size), size);
    if (isEmpty || arguments.size() < 2 || arguments[1].is(Kind::Null)) return;
    for (long long i = 0; i != size.number; ++i) memory_.store(at.element(i), arguments[1]);
}

void Containers::append(const clang::CXXMemberCallExpr& expression, const Place& to, bool constructs) {
    const clang::QualType container = expression.getObjectType();
    const clang::QualType type = firstArgument(container);
    const Values arguments = calls_.argumentsOf(expression);
    const auto size = memory_.sizeOf(to);
    if (!size || *size >= kMostElements || !findings_.isCertain() || type.isNull()) return memory_.forget(to);
    const Place at = to.element(*size);
    const bool isObject = type->isRecordType() && !isPointerLike(type) && !isStdString(type);
    if (isObject && constructs) {
        objects_.makeAt(at, type, arguments, expression.getExprLoc());
    } else if (arguments.size() == 1) {
        if (const Element* known = arguments[0].is(Kind::Place) ? registry_.elementAt(arguments[0].place) : nullptr)
            registry_.elements[at] = *known;
        memory_.erase(at);  // of an earlier element
        memory_.store(at, arguments[0]);
    }
    memory_.noteChange(at);
    memory_.set(to.of(Place::Kind::Size), Value::ofNumber(*size + 1));
}

std::optional<Value> Containers::call(const clang::CXXMemberCallExpr& expression, const std::string& name,
                                      const Value& object) {
    const clang::QualType type = expression.getObjectType();
    if (!isSequence(type) || !object.is(Kind::Place)) return std::nullopt;
    const Place& at = object.place;
    const auto size = memory_.sizeOf(at);
    const unsigned count = expression.getNumArgs();
    if (name == "push_back" || name == "emplace_back") {
        append(expression, at, name == "emplace_back");
        return size ? Value::ofPlace(at.element(*size)) : Value();
    }
    if (name == "reserve" || name == "shrink_to_fit") return Value();
    if ((name == "resize" && count == 1) || name == "clear") {
        const Value wanted = name == "clear" ? Value::ofNumber(0) : values_.content(expression.getArg(0));
        const bool known = findings_.isCertain() && wanted.is(Kind::Number) && wanted.number <= kMostElements;
        if (!known || !size || wanted.number < *size) memory_.forget(at);
        memory_.noteChange(at.element(0));
        if (known) memory_.set(at.of(Place::Kind::Size), wanted);
        return Value();
    }
    if (name == "at" && count == 1) {
        const Value index = values_.content(expression.getArg(0));
        return index.is(Kind::Number) ? Value::ofPlace(at.element(index.number)) : Value();
    }
    if (name == "begin" || name == "cbegin" || (name == "front" && size)) return Value::ofPlace(at.element(0));
    if (!size) return std::nullopt;
    if (name == "size") return Value::ofNumber(*size);
    if (name == "empty") return Value::ofBoolean(*size == 0);
    if (name == "end" || name == "cend") return Value::ofPlace(at.element(*size));
    if (name == "back" && *size > 0) return Value::ofPlace(at.element(*size - 1));
    return std::nullopt;
}

std::optional<Value> Containers::operate(const clang::CXXOperatorCallExpr& expression) {
    const auto kind = expression.getOperator();
    const clang::Expr* first = expression.getArg(0);
    if (!isIterator(first->getType())) return std::nullopt;
    if (kind == clang::OO_PlusPlus || kind == clang::OO_MinusMinus) {
        const Value target = values_.eval(first), before = memory_.load(target);
        if (target.is(Kind::Place)) memory_.assign(target.place, moved(before, kind == clang::OO_PlusPlus ? 1 : -1));
        return expression.getNumArgs() == 1 ? target : before;
    }
    if (expression.getNumArgs() != 2) return std::nullopt;
    const clang::Expr* second = expression.getArg(1);
    if (kind == clang::OO_EqualEqual || kind == clang::OO_ExclaimEqual) {
        const Value a = values_.pointed(first), b = values_.pointed(second);
        if (!hasPosition(a) || !hasPosition(b) || a.place.whole() != b.place.whole()) return Value();
        return Value::ofBoolean((a.place == b.place) == (kind == clang::OO_EqualEqual));
    }
    if (kind == clang::OO_Plus && second->getType()->isIntegerType()) {
        const Value by = values_.content(second);
        return by.is(Kind::Number) ? moved(values_.pointed(first), by.number) : Value();
    }
    return std::nullopt;
}

Value Containers::endOf(const clang::CallExpr& expression, const std::string& name) {
    const Value whole = values_.eval(expression.getArg(0));
    if (!whole.is(Kind::Place)) return {};
    if (name == "begin" || name == "cbegin") return Value::ofPlace(whole.place.element(0));
    const auto* array = context_.getAsConstantArrayType(expression.getArg(0)->getType());
    const auto size =
        array != nullptr ? std::optional<long long>(array->getSize().getSExtValue()) : memory_.sizeOf(whole.place);
    return size ? Value::ofPlace(whole.place.element(*size)) : Value();
}

Value Containers::eachOf(const clang::CallExpr& expression) {
    const Value from = values_.pointed(expression.getArg(0)), to = values_.pointed(expression.getArg(1));
    const Value function = memory_.load(values_.eval(expression.getArg(2)));
    if (!hasPosition(from) || !hasPosition(to) || from.place.whole() != to.place.whole() ||
        to.place.index() - from.place.index() > kMostElements || !function.is(Kind::Function) ||
        function.function == nullptr)
        return {};
    const clang::FunctionDecl* definition = definitionOf(*function.function);
    if (definition == nullptr || definition->isDependentContext()) return {};  // a generic lambda without an instance
    for (long long i = from.place.index(); i < to.place.index(); ++i) {
        const Place element = from.place.whole().element(i);
        const bool isLocal = definition->getNumParams() == 1 &&
                             !definition->getParamDecl(0)->getType()->isReferenceType() &&
                             !definition->getParamDecl(0)->getType()->isRecordType();
        const Value argument = isLocal ? memory_.load(Value::ofPlace(element)) : Value::ofPlace(element);
        calls_.invoke(*definition, {argument}, stack_.top().self, /*lambda=*/true);
    }
    return {};
}

}  // namespace oroforge::cxx
