// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "evaluator.hpp"
#include "interface_calls.hpp"

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

std::optional<Value> ElementCalls::call(const clang::CallExpr& expression, const std::string& name,
                                        const Place& object) {
    Element* element = registry_.elementAt(object);
    if (element == nullptr) return std::nullopt;
    const unsigned count = expression.getNumArgs();
    const Value self = Value::ofPlace(object);
    if ((name == "doc" || name == "setDescription" || name == "setName") && count == 1) {
        const auto text = values_.textOf(expression.getArg(0));
        const bool isDoc = name != "setName";
        if (!findings_.isCertain() || !text) {
            const std::string why = text ? "is set " + findings_.why() : "is not constant";
            findings_.remark(expression.getExprLoc(), text ? "OC022" : "OC021",
                             std::string("the ") + (isDoc ? "documentation" : "name") + " of this " +
                                 shown(element->kind) + " " + why);
        } else if (isDoc) {
            element->doc = *text;
        } else {
            element->name = text;
        }
        return self;
    }
    if (name == "arg" && count == 2) {
        const auto argument = values_.textOf(expression.getArg(0)), doc = values_.textOf(expression.getArg(1));
        const std::size_t at = element->documented++;
        if (!argument || !doc)
            findings_.remark(expression.getExprLoc(), "OC021",
                             "the name or documentation of this argument is not constant");
        if (at >= element->arguments.size()) return self;
        if (argument) element->arguments[at].name.value = *argument;
        if (doc) element->arguments[at].doc = *doc;
        element->arguments[at].where = findings_.locate(expression.getArg(0)->getExprLoc());
        return self;
    }
    if (name == "calls") {
        for (const Value& value : calls_.argumentsOf(expression)) {
            const Value argument = memory_.load(value);
            if (argument.text.find("OwnThread") != std::string::npos) element->own = true;
        }
        return self;
    }
    if (name == "signals" && count == 0) return self;
    if ((name == "set" || name == "value") && count == 0) return Value::ofPlace(element->value);
    if (name == "set" && count == 1 && !element->value.empty()) {
        const Value value = values_.eval(expression.getArg(0));
        const bool isObject = value.is(Kind::Place) && memory_.find(value.place) == nullptr;
        if (isObject) memory_.forget(element->value);
        if (isObject) memory_.copy(value.place, element->value);
        if (!isObject) memory_.assign(element->value, values_.converted(memory_.load(value), element->valueType));
        return Value();
    }
    if (name == "get" || name == "rvalue") return memory_.load(Value::ofPlace(element->value));
    return std::nullopt;
}

}  // namespace oroforge::cxx
