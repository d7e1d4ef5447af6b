// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <check/check.hpp>

#include <cctype>

#include <model/cpp_type.hpp>
#include <model/interfaces.hpp>

namespace oroforge::check {

namespace {

/// The use of a type decides which types are allowed.
enum class Use { Value, Argument, Result };

/// Returns why `type` cannot be a C++ type name; empty if it can.
std::string spellingFault(const std::string& type) {
    int depth = 0;
    for (std::size_t i = 0; i < type.size(); ++i) {
        const char c = type[i];
        if (c == '<' || c == '(') ++depth;
        if (c == '>' || c == ')') --depth;
        if (depth < 0) return "has a closing bracket too many";
        if (c == ':') {
            if (i + 1 >= type.size() || type[i + 1] != ':') return "has a single ':', expected '::'";
            ++i;
        } else if (std::isalnum(static_cast<unsigned char>(c)) == 0 &&
                   std::string("_<>(), *&\t").find(c) == std::string::npos) {
            return std::string("contains '") + c + "', which no type name does";
        }
    }
    if (depth != 0) return "has an opening bracket without a closing one";
    if (type.find_first_not_of(" \t") == std::string::npos) return "is empty";
    return {};
}

std::string standardName(const std::string& type) {
    for (const char* word : {"string", "vector", "array", "map", "pair"}) {
        const std::string name(word);
        if (type.compare(0, name.size(), name) != 0) continue;
        if (type.size() == name.size() || type[name.size()] == '<') return "std::" + type;
    }
    return {};
}

bool isConst(const std::string& type) { return type.compare(0, 6, "const ") == 0; }

void checkType(const std::string& what, const model::Text& given, Use use, diag::Sink& sink) {
    if (!given.given()) return;
    const std::string type = model::normalised(given.value);
    const std::string text = what + " type '" + given.value + "' ";
    const std::string fault = spellingFault(given.value);
    if (!fault.empty()) {
        sink.error(given.where, "OM020", text + fault);
    } else if (const std::string full = standardName(type); !full.empty()) {
        sink.error(given.where, "OM021", text + "is not a type by itself; expected '" + full + "'");
    } else if (type.find('*') != std::string::npos) {
        sink.error(given.where, "OM022", text + "is a pointer; expected a type that is copied by value");
    } else if (use != Use::Argument && type.find('&') != std::string::npos) {
        sink.error(given.where, "OM022", text + "is a reference; expected a type that is copied by value");
    } else if (use != Use::Argument && isConst(type)) {
        sink.error(given.where, "OM022", text + "is const; expected a type that can be assigned");
    } else if (type == "void" && use != Use::Result) {
        sink.error(given.where, "OM023", text + "has no value; 'void' is for operations that return nothing");
    } else if (type == "auto") {
        sink.error(given.where, "OM020", text + "is not the name of a type");
    }
}

void checkOperation(const model::Operation& operation, diag::Sink& sink) {
    checkType("return", operation.returns, Use::Result, sink);
    for (const auto& argument : operation.arguments) checkType("argument", argument.type, Use::Argument, sink);
}

}  // namespace

void types(const model::Package& package, diag::Sink& sink) {
    model::eachInterface(package, [&](const model::Interface& interface, const model::ServicePath&) {
        for (const auto& port : interface.ports) checkType("port", port.type, Use::Value, sink);
        for (const auto& property : interface.properties) checkType("property", property.type, Use::Value, sink);
        for (const auto& attribute : interface.attributes) checkType("attribute", attribute.type, Use::Value, sink);
        for (const auto& operation : interface.operations) checkOperation(operation, sink);
    });
    for (const auto& component : package.components) {
        for (const auto& service : component.required) {
            for (const auto& operation : service.operations) checkOperation(operation, sink);
        }
    }
}

}  // namespace oroforge::check
