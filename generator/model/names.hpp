// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// How C++ names what a manifest names. Views, --update and checks all ask here.
#ifndef OROFORGE_GENERATOR_MODEL_NAMES_HPP
#define OROFORGE_GENERATOR_MODEL_NAMES_HPP

#include <string>

#include <model/cpp_type.hpp>
#include <model/interfaces.hpp>

namespace oroforge::model {

/// "tank" of "tank::Controller", "" of "Controller".
inline std::string namespaceOf(const std::string& qualified) {
    const auto at = qualified.rfind("::");
    return at == std::string::npos ? std::string() : qualified.substr(0, at);
}

/// "Controller" of "tank::Controller".
inline std::string lastName(const std::string& qualified) { return splitQualified(qualified).back(); }

/// The generated class below the user's.
inline std::string baseName(const std::string& className) { return className + "Base"; }

/// "gripper.open": how the user tells "open" of the service "gripper" from others.
inline std::string fullName(const ServicePath& path, const std::string& name) {
    std::string result;
    for (const std::string& service : path) result += service + ".";
    return result + name;
}

/// "gripper_open"
inline std::string methodName(const ServicePath& path, const std::string& name) {
    std::string result;
    for (const std::string& service : path) result += service + "_";
    return result + name;
}

inline std::string methodName(const Hook& hook) { return std::string(hook.name) + "Hook"; }

/// The member that holds what methodName() names: "gripper_force_".
inline std::string memberName(const std::string& methodName) { return methodName + "_"; }

/// What leads from the component to a service: provides("gripper")->
inline std::string accessTo(const ServicePath& path) {
    std::string result;
    for (const std::string& service : path) result += "provides(\"" + service + "\")->";
    return result;
}

}  // namespace oroforge::model

#endif
