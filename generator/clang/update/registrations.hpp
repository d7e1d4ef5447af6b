// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds calls in methods that register members with the component: addPort("level", level_).
#ifndef OROFORGE_GENERATOR_CLANG_UPDATE_REGISTRATIONS_HPP
#define OROFORGE_GENERATOR_CLANG_UPDATE_REGISTRATIONS_HPP

#include <string>
#include <vector>

#include <model/user_code.hpp>

#include "source_run.hpp"

namespace oroforge::cxx {

std::vector<model::UserRegistration> registrationsIn(const clang::CXXMethodDecl& method, const PackagePlaces& places);

/// Returns the first string in an initialiser; empty if there is none.
std::string firstString(const clang::Stmt* value);

}  // namespace oroforge::cxx

#endif
