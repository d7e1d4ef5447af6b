// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_MERGE_PLAN_REGISTRATION_HPP
#define OROFORGE_GENERATOR_MERGE_PLAN_REGISTRATION_HPP

#include <string>

#include <merge/plan.hpp>

namespace oroforge::merge {

/// A registered item, as messages name it.
struct Registered {
    std::string what;  ///< "port 'level'"
    std::string shown;
    diag::Location where;  ///< in the manifest
    bool takeManifest = false;
};

/// Lets a call such as addPort("level", level_).doc("The level") follow the manifest: name, thread, doc() and arg().
/// Text that the user changed stays; if the manifest changed as well, that is an error. Missing parts are added only if
/// they are new in the manifest. Returns false after an error.
bool planRegistration(const Registration& wanted, const Registration* last, const model::UserRegistration& call,
                      const Registered& names, const Input& input, Plan& into, diag::Sink& sink);

}  // namespace oroforge::merge

#endif
