// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Compares two versions of a package's types: do plugins, files and sources made for the old one still work?
#ifndef OROFORGE_TYPEKIT_GEN_DIFF_COMPARE_MODELS_HPP
#define OROFORGE_TYPEKIT_GEN_DIFF_COMPARE_MODELS_HPP

#include <string>
#include <vector>

#include <diag/diagnostic.hpp>
#include <model/type_model.hpp>

namespace oroforge::typekit {

struct Change {
    bool breaking = false;
    std::string message;
    diag::Location where;  ///< in the new version; in the old one if the item is gone
    diag::Location was;    ///< in the old version, if both versions have the item
};

/// Returns changes in the order of the new types, then of old types that are gone. A change is breaking if the runtime
/// refuses to connect ports of the two versions (see RTT::types::schemaDifference()), if property files or sources use
/// a name that is gone, if a value can no longer be written, or if a struct is no longer the message of ROS that it
/// was.
std::vector<Change> compareModels(const model::TypeModel& old, const model::TypeModel& now);

}  // namespace oroforge::typekit

#endif
