// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What the manifest wants in the user's classes.
#ifndef OROFORGE_GENERATOR_MERGE_WANTED_HPP
#define OROFORGE_GENERATOR_MERGE_WANTED_HPP

#include <functional>
#include <string>
#include <vector>

#include <diag/diagnostic.hpp>
#include <merge/record.hpp>
#include <model/package.hpp>
#include <model/user_code.hpp>

namespace oroforge::merge {

struct WantedMethod {
    std::string name;
    std::string shown;  ///< in the manifest: "finish", "gripper.open", "startHook"
    model::Signature signature;
    bool isHook = false;
    std::vector<std::string> comment;  ///< lines of documentation
    std::vector<std::string> body;     ///< lines of a first definition, not indented
    std::string path;                  ///< provides("gripper")-> if it belongs to a service
    std::string operation;             ///< its name in the interface
    Registration registration;
    std::string registrationText;  ///< addOperation("finish", …).doc("…")
    diag::Location where;
};

/// A data member of a class without a generated base.
struct WantedMember {
    std::string kind;         ///< "port", "property" or "attribute"
    std::string name;         ///< "level"
    std::string shown;        ///< in the manifest: "level", "gripper.force"
    std::string path;         ///< provides("gripper")-> if it belongs to a service
    std::string method;       ///< name of the data member without the user's prefix or suffix
    std::string type;         ///< in the manifest
    std::string portClass;    ///< "InputPort" or "OutputPort" of a port
    std::string declared;     ///< the type in C++ with its qualifier: "const double"
    std::string initialiser;  ///< " = 1.5", "{}" or nothing
    std::string comment;      ///< in one line; may be empty
    Registration registration;
    diag::Location where;
};

struct WantedClass {
    std::string name;  ///< qualified
    std::string base;  ///< qualified name of the generated class
    bool isComponent = true;
    std::vector<WantedMethod> methods;
    std::vector<WantedMember> members;
    diag::Location where;
};

/// Returns the lines of a first definition of "configure", "start" …, not indented.
using BodyOfHook = std::function<std::vector<std::string>(const std::string& hook)>;

/// Returns components first, then services.
std::vector<WantedClass> wantedClasses(const model::Package& package, const BodyOfHook& bodyOf);

}  // namespace oroforge::merge

#endif
