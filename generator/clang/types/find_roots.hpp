// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The types that the user asks for: structs, classes and enums defined in the listed headers.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_FIND_ROOTS_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_FIND_ROOTS_HPP

#include <string>
#include <vector>

#include <clang/base/source_places.hpp>

#include "adapter_match.hpp"

namespace oroforge::cxx {

struct Root {
    const clang::TagDecl* type;
    clang::SourceLocation at;  ///< where it is asked for
    std::string alias;         ///< name in the type registry of the alias that asks for a template instance
};

/// In source order. Of class templates that are written in the listed headers these instances: those with an alias
/// (`using Pose3 = Pose<3>;`), and those of `template struct Pose<2>;`. Left out: other instances (they come in through
/// fields), nested types that are not public, unnamed types and types local to functions. An alias in a listed header asks
/// for a class that has an adapter, too, wherever that is written.
std::vector<Root> findRoots(const clang::ASTContext& context, const SourcePlaces& places,
                            const AdapterFinder& adapters);

}  // namespace oroforge::cxx

#endif
