// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What the manifest wants in the classes of the user.
#ifndef OROFORGE_GENERATOR_MERGE_WANTED_HPP
#define OROFORGE_GENERATOR_MERGE_WANTED_HPP

#include <string>
#include <vector>

#include <diag/diagnostic.hpp>
#include <model/user_code.hpp>

namespace oroforge::merge {

struct WantedMethod {
    std::string name;
    std::string shown;  ///< in the manifest: "finish", "gripper.open", "startHook"
    model::Signature signature;
    bool isHook = false;
    std::vector<std::string> comment;  ///< lines of documentation
    std::vector<std::string> body;     ///< lines of a first definition, not indented
    std::string path;                  ///< provides("gripper")-> for those of a service
    std::string operation;             ///< its name in the interface
    std::string registration;          ///< addOperation("finish", …).doc("…"), for classes that do it themselves
    diag::Location where;
};

/// For classes without a generated base.
struct WantedMember {
    std::string kind;         ///< "port", "property" or "attribute"
    std::string name;         ///< "level"
    std::string shown;        ///< in the manifest: "level", "gripper.force"
    std::string path;         ///< provides("gripper")-> for those of a service
    std::string method;       ///< name of the data member without what the user puts before or behind names
    std::string type;         ///< in the manifest
    std::string portClass;    ///< "InputPort" or "OutputPort" of a port
    std::string declared;     ///< the type in C++ with its qualifier: "const double"
    std::string initialiser;  ///< " = 1.5", "{}" or nothing
    std::string comment;      ///< in one line; may be empty
    std::string verb;         ///< "addPort"
    std::string doc;          ///< .doc("…") or nothing
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

}  // namespace oroforge::merge

#endif
