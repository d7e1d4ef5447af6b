// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <clang/base/type_names.hpp>

#include "describe_adapted.hpp"

namespace oroforge::cxx {

using adapters::Accessor;

namespace {

/// An object has ".Zero()", the class "::Zero()".
std::string ofClass(const std::string& cpp, const Accessor& call) { return cpp + "::" + cppOf(call).substr(1); }

std::string parameter(const model::TypeUse& use, const std::string& name) {
    const bool isNumber = use.kind == model::TypeKind::Scalar || use.kind == model::TypeKind::Enum;
    return (isNumber ? use.cpp + " " : "const " + use.cpp + "& ") + name;
}

}  // namespace

std::string AdaptedDescriber::initial(const std::string& cpp) {
    if (!adapter_.initial.given()) return "";
    subject_ = "'initial'";
    const Accessor call = bound(adapter_.initial, match_.cpp);
    const Accessed made = check_.access(call, /*isConst=*/true);
    if (made.expression == nullptr) {
        fail(adapter_.initial, "TK072", "the compiler says: " + made.error);
        return "";
    }
    const std::string error = check_.makesValue(made);
    if (!error.empty()) fail(adapter_.initial, "TK073", "it makes no first value: " + error);
    return ofClass(cpp, call);
}

std::vector<model::Constructor> AdaptedDescriber::constructors(const std::string& cpp) {
    std::vector<model::Constructor> result;
    for (const adapters::Constructor& given : adapter_.constructors)
        if (const auto made = constructor(given, cpp)) result.push_back(*made);
    return result;
}

std::optional<model::Constructor> AdaptedDescriber::constructor(const adapters::Constructor& given,
                                                                const std::string& cpp) {
    model::Constructor result;
    std::map<std::string, clang::QualType> words;
    std::vector<clang::QualType> types;
    std::string names;
    Accessor text;
    subject_ = "<constructor>";
    for (const adapters::Constructor::Argument& argument : given.arguments) {
        text.text = argument.type + " " + argument.name;
        text.where = argument.where;
        const auto type = typeOf(argument);
        const auto use = type ? classify(text, *type) : std::nullopt;
        if (!use) return std::nullopt;
        types.push_back(*type);
        words.emplace(argument.name, *type);
        result.arguments.push_back(*use);
        result.parameters += (result.parameters.empty() ? "" : ", ") + parameter(*use, argument.name);
        names += (names.empty() ? "" : ", ") + argument.name;
    }
    text.text = names;
    std::string error;
    if (given.call.given()) {
        const Accessor call = bound(given.call, match_.cpp);
        check_.setWords(words);
        const Accessed made = check_.access(call, /*isConst=*/true);
        check_.setWords({});
        error = made.expression == nullptr ? made.error : check_.makesValue(made);
        result.value = ofClass(cpp, call);
    } else {
        error = check_.construct(types);
        result.value = cpp + "(" + names + ")";
    }
    if (error.empty()) return result;
    fail(given.call.given() ? given.call : text, "TK072", "the compiler says: " + error);
    return std::nullopt;
}

std::optional<clang::QualType> AdaptedDescriber::typeOf(const adapters::Constructor::Argument& argument) {
    const bool isVariable = argument.type[0] == '$';
    const auto bound = isVariable ? match_.cpp.find(argument.type.substr(1)) : match_.cpp.end();
    const std::string name = bound != match_.cpp.end() ? bound->second : argument.type;
    std::string nearest;
    const auto type = typeCalled(name, types_.sema().getASTContext(), nearest);
    if (type) return type->getCanonicalType();
    Accessor text;
    text.text = argument.type + " " + argument.name;
    text.where = argument.where;
    fail(text, "TK072",
         "no type '" + name + "' in the headers" + nearest +
             "; expected bool, char, int, unsigned, float, double or a class");
    return std::nullopt;
}

}  // namespace oroforge::cxx
