// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Writes values of classes as C++ that means the same anywhere.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_CONSTANT_TEXT_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_CONSTANT_TEXT_HPP

#include <optional>
#include <string>

#include <clang/base/llvm_compat.hpp>

namespace oroforge::cxx {

/// Returns an initialiser for "TYPE variable = ": "{1, 2}", "std::vector<double>(3, 0.5)". Returns nothing if it needs
/// variables, functions, or names from macros.
std::optional<std::string> constantText(clang::QualType type, const clang::Expr& init,
                                        const clang::ASTContext& context);

}  // namespace oroforge::cxx

#endif
