// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds the types that the user requests: structs, classes and enums defined in the listed headers.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_FIND_ROOTS_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_FIND_ROOTS_HPP

#include <string>
#include <vector>

#include <clang/base/source_places.hpp>

#include "adapter_match.hpp"

namespace oroforge::cxx {

struct Root {
    const clang::TagDecl* type;
    clang::SourceLocation at;  ///< place of the request
    std::string alias;         ///< name in the type registry of the alias that requests a template instance
};

/// Returns types in source order. Class templates written in the listed headers give instances with an alias (`using
/// Pose3 = Pose<3>;`) and those of `template struct Pose<2>;`. Leaves out other instances (fields lead to them), nested
/// types that are not public, unnamed types and types local to functions. An alias in a listed header also requests a
/// class that has an adapter, wherever the class is written.
std::vector<Root> findRoots(const clang::ASTContext& context, const SourcePlaces& places,
                            const AdapterFinder& adapters);

}  // namespace oroforge::cxx

#endif
