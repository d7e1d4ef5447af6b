// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Maps names of a manifest to names in C++. Views, --update and checks share these rules.
#ifndef OROFORGE_GENERATOR_MODEL_NAMES_HPP
#define OROFORGE_GENERATOR_MODEL_NAMES_HPP

#include <string>

#include <model/cpp_type.hpp>
#include <model/interfaces.hpp>

namespace oroforge::model {

/// Returns "tank" for "tank::Controller", "" for "Controller".
inline std::string namespaceOf(const std::string& qualified) {
    const auto at = qualified.rfind("::");
    return at == std::string::npos ? std::string() : qualified.substr(0, at);
}

/// Returns "Controller" for "tank::Controller".
inline std::string lastName(const std::string& qualified) { return splitQualified(qualified).back(); }

/// The generated base class of the user's class.
inline std::string baseName(const std::string& className) { return className + "Base"; }

/// Returns "gripper.open": the name in messages, which tells "open" of the service "gripper" from others.
inline std::string fullName(const ServicePath& path, const std::string& name) {
    std::string result;
    for (const std::string& service : path) result += service + ".";
    return result + name;
}

/// Returns "gripper_open".
inline std::string methodName(const ServicePath& path, const std::string& name) {
    std::string result;
    for (const std::string& service : path) result += service + "_";
    return result + name;
}

inline std::string methodName(const Hook& hook) { return std::string(hook.name) + "Hook"; }

/// Returns the member for a methodName(): "gripper_force_".
inline std::string memberName(const std::string& methodName) { return methodName + "_"; }

/// Returns the C++ that leads from the component to a service: provides("gripper")->
inline std::string accessTo(const ServicePath& path) {
    std::string result;
    for (const std::string& service : path) result += "provides(\"" + service + "\")->";
    return result;
}

}  // namespace oroforge::model

#endif
