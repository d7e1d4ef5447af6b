// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The types that the user asks for: structs, classes and enums defined in the listed headers.
#ifndef OROFORGE_GENERATOR_CLANG_FIND_ROOTS_HPP
#define OROFORGE_GENERATOR_CLANG_FIND_ROOTS_HPP

#include <vector>

#include "source_places.hpp"

namespace oroforge::cxx {

/// In source order. Left out: templates and their specialisations (their instances come in through fields),
/// nested types that are not public, unnamed types and types local to functions.
std::vector<const clang::TagDecl*> findRoots(const clang::ASTContext& context, const SourcePlaces& places);

}  // namespace oroforge::cxx

#endif
