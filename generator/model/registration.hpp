// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The C++ that declares a part of an interface and registers it.
#ifndef OROFORGE_GENERATOR_MODEL_REGISTRATION_HPP
#define OROFORGE_GENERATOR_MODEL_REGISTRATION_HPP

#include <string>

#include <model/literal.hpp>
#include <model/package.hpp>

namespace oroforge::model {

inline const char* portClass(const Port& port) { return port.direction == Direction::In ? "InputPort" : "OutputPort"; }
inline const char* qualifierOf(const Attribute& attribute) { return attribute.constant ? "const " : ""; }
inline std::string returnsOf(const Operation& operation) {
    return operation.returns.given() ? operation.returns.value : "void";
}

/// Returns the result of a new method that does nothing yet; nothing for void.
inline const char* firstResult(const Operation& operation) {
    const std::string returns = returnsOf(operation);
    return returns == "void" ? "" : returns == "bool" ? "true" : "{}";
}

/// " = 1.5" or "{}"
inline std::string initialiser(const Text& value, const std::string& type) {
    return value.given() ? " = " + valueLiteral(value.value, type) : "{}";
}

inline const char* registrationOf(const Port& port) { return port.event ? "addEventPort" : "addPort"; }
inline const char* registrationOf(const Property& /*property*/) { return "addProperty"; }
inline const char* registrationOf(const Attribute& attribute) {
    return attribute.constant ? "addConstant" : "addAttribute";
}
inline const char* threadOf(const Operation& operation) {
    return operation.thread == Thread::Own ? "OwnThread" : "ClientThread";
}

}  // namespace oroforge::model

#endif
