// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What changed between two versions of a package's types, and whether plugins, files and sources of the old one still fit.
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
    diag::Location where;  ///< in the new version; of what is gone, in the old one
    diag::Location was;    ///< in the old version, if it is in both
};

/// In the order of the new types, then of the old ones that are gone. Breaking is what makes the runtime refuse to connect
/// ports of the two versions (see RTT::types::schemaDifference()), what property files or sources name and no longer find,
/// and what can no longer be written.
std::vector<Change> compareModels(const model::TypeModel& old, const model::TypeModel& now);

}  // namespace oroforge::typekit

#endif
