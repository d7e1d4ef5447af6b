// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Other names of the types that the user asks for: `typedef S T;`, `using T = S;`.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_FIND_NAMES_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_FIND_NAMES_HPP

#include "find_roots.hpp"

namespace oroforge::cxx {

/// A name that an alias in a listed header gives to a struct or enum which is asked for anyway.
struct OtherName {
    const clang::TagDecl* type;
    clang::SourceLocation at;
    std::string alias;  ///< in the type registry
};

/// In source order, each name once. Left out: aliases that ask for what they name (they are roots), those of constant
/// types, those that are not public, and the name that C's `typedef struct {…} T;` gives, which is the type's only one.
std::vector<OtherName> findNames(const clang::ASTContext& context, const SourcePlaces& places,
                                 const std::vector<Root>& roots);

}  // namespace oroforge::cxx

#endif
