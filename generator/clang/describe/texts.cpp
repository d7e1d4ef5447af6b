// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <sstream>

#include <clang/base/type_names.hpp>

#include "evaluator.hpp"
#include "known_types.hpp"

namespace oroforge::cxx {

namespace {

using Kind = Value::Kind;

/// Returns text to append: a text or a character.
std::optional<std::string> wordOf(const Value& value) {
    if (value.is(Kind::Text)) return value.text;
    if (value.is(Kind::Number)) return std::string(1, static_cast<char>(value.number));
    return std::nullopt;
}

/// Returns the text that a stream prints.
std::optional<std::string> printedText(const Value& value, clang::QualType type, const clang::ASTContext& context) {
    if (value.is(Kind::Text)) return value.text;
    if (value.is(Kind::Boolean)) return std::string(value.number != 0 ? "1" : "0");
    if (value.is(Kind::Number) && type->isAnyCharacterType() && context.getTypeSize(type) == 8) return wordOf(value);
    std::ostringstream out;
    if (value.is(Kind::Number) && type->isUnsignedIntegerType()) {
        out << static_cast<unsigned long long>(value.number);
    } else if (value.is(Kind::Number)) {
        out << value.number;
    } else if (value.is(Kind::Real)) {
        out << value.real;
    } else {
        return std::nullopt;
    }
    return out.str();
}

}  // namespace

std::optional<Value> Texts::operate(const clang::CXXOperatorCallExpr& expression) {
    const auto kind = expression.getOperator();
    const clang::Expr* first = expression.getArg(0);
    const clang::Expr* second = expression.getNumArgs() == 2 ? expression.getArg(1) : nullptr;
    if (second == nullptr || (!isStdString(first->getType()) && !isStdString(second->getType()))) return std::nullopt;
    const bool adds = kind == clang::OO_PlusEqual;
    const bool changes = (adds || kind == clang::OO_Equal) && isStdString(first->getType());
    if (!changes && kind != clang::OO_Plus && kind != clang::OO_EqualEqual && kind != clang::OO_ExclaimEqual)
        return std::nullopt;
    const Value target = values_.eval(first);
    const auto a = wordOf(memory_.load(target)), b = wordOf(memory_.load(values_.eval(second)));
    if (changes) {
        const bool known = b && (a || !adds);
        if (target.is(Kind::Place))
            memory_.assign(target.place, known ? Value::ofText((adds ? *a : "") + *b) : Value());
        return target;
    }
    if (!a || !b) return Value();
    return kind == clang::OO_Plus ? Value::ofText(*a + *b)
                                  : Value::ofBoolean((*a == *b) == (kind == clang::OO_EqualEqual));
}

Value Texts::printed(const clang::Expr& expression) {
    const auto text = printedText(memory_.load(values_.eval(&expression)), expression.getType(), context_);
    return text ? Value::ofText(*text) : Value();
}

void Texts::stream(const Place& into, const clang::Expr& what) {
    const Place text = into.of(Place::Kind::Text);
    if (memory_.find(text) == nullptr) return;
    const Value more = printed(what), before = *memory_.find(text);
    const bool known = more.known() && before.is(Kind::Text);
    memory_.assign(text, known ? Value::ofText(before.text + more.text) : Value());
}

std::optional<Value> Texts::call(const clang::CXXMemberCallExpr& expression, const std::string& name,
                                 const Value& object) {
    const unsigned count = expression.getNumArgs();
    const Value* streamed = object.is(Kind::Place) ? memory_.find(object.place.of(Place::Kind::Text)) : nullptr;
    if (name == "str" && streamed != nullptr) {
        if (count == 0) return *streamed;
        const auto text = values_.textOf(expression.getArg(0));
        memory_.assign(object.place.of(Place::Kind::Text), text ? Value::ofText(*text) : Value());
        return Value();
    }
    const Value text = memory_.load(object);
    const clang::Expr* on = expression.getImplicitObjectArgument();
    const clang::QualType type = on->getType()->isPointerType() ? on->getType()->getPointeeType() : on->getType();
    if (!isStdString(type) || !text.is(Kind::Text)) return std::nullopt;
    if (name == "c_str" || name == "data") return text;
    if (name == "empty") return Value::ofBoolean(text.text.empty());
    if (name == "size" || name == "length") return Value::ofNumber(static_cast<long long>(text.text.size()));
    if ((name == "append" || name == "push_back") && count == 1 && object.is(Kind::Place)) {
        const auto more = wordOf(values_.content(expression.getArg(0)));
        memory_.assign(object.place, more ? Value::ofText(text.text + *more) : Value());
        return object;
    }
    if (name == "substr" && count != 0) {
        const Value from = values_.content(expression.getArg(0));
        const bool hasLength = count == 2 && !llvm::isa<clang::CXXDefaultArgExpr>(expression.getArg(1));
        const Value length = hasLength ? values_.content(expression.getArg(1)) : Value::ofNumber(-1);
        const auto start = static_cast<std::size_t>(from.number);
        if (!from.is(Kind::Number) || !length.is(Kind::Number) || start > text.text.size()) return Value();
        return Value::ofText(text.text.substr(start, static_cast<std::size_t>(length.number)));
    }
    return std::nullopt;
}

}  // namespace oroforge::cxx
