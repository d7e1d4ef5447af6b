// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds other names of requested types: `typedef S T;`, `using T = S;`.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_FIND_NAMES_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_FIND_NAMES_HPP

#include "find_roots.hpp"

namespace oroforge::cxx {

/// An alias in a listed header of a struct or enum that is requested anyway.
struct OtherName {
    const clang::TagDecl* type;
    clang::SourceLocation at;
    std::string alias;  ///< in the type registry
};

/// Returns each name once, in source order. Leaves out aliases that request a type (roots), aliases of constant types,
/// aliases that are not public, and the name in C's `typedef struct {…} T;`, which is the type's only one.
std::vector<OtherName> findNames(const clang::ASTContext& context, const SourcePlaces& places,
                                 const std::vector<Root>& roots);

}  // namespace oroforge::cxx

#endif
