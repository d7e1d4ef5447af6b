// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_MERGE_PLAN_REGISTRATION_HPP
#define OROFORGE_GENERATOR_MERGE_PLAN_REGISTRATION_HPP

#include <string>

#include <merge/plan.hpp>

namespace oroforge::merge {

/// What is registered, as messages call it.
struct Registered {
    std::string what;  ///< "port 'level'"
    std::string shown;
    diag::Location where;  ///< in the manifest
    bool takeManifest = false;
};

/// A call such as addPort("level", level_).doc("The level") follows the manifest: its name, thread, doc() and arg(). What the
/// user wrote otherwise stays; if the manifest changed as well, that is an error. What is not in the code is not put there
/// unless it is new in the manifest. False if there was an error.
bool planRegistration(const WantedRegistration& wanted, const RecordedRegistration* last,
                      const model::UserRegistration& call, const Registered& names, const Input& input, Plan& into,
                      diag::Sink& sink);

RecordedRegistration recordOf(const WantedRegistration& wanted);

}  // namespace oroforge::merge

#endif
