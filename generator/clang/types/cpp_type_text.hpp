// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Writes types as a manifest names them.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_CPP_TYPE_TEXT_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_CPP_TYPE_TEXT_HPP

#include <string>

#include <clang/base/llvm_compat.hpp>

namespace oroforge::cxx {

/// Returns the type with its namespaces, as the user wrote it if possible: "std::vector<tank::Sample>", "const
/// std::string&", "std::uint8_t". Default arguments of the standard library's templates are left out.
std::string cppTypeText(clang::QualType type, const clang::ASTContext& context);

/// Returns the first template argument of a type such as InputPort<T>; null if it has none.
clang::QualType firstArgument(clang::QualType type);

}  // namespace oroforge::cxx

#endif
