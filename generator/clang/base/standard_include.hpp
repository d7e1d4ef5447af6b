// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds the missing header if the compiler does not know a name of the standard library.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_STANDARD_INCLUDE_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_STANDARD_INCLUDE_HPP

#include <string>

#include "llvm_compat.hpp"

namespace oroforge::cxx {

/// Returns "#include <vector>" for an error about std::vector with this `message`; empty for other errors.
std::string missingInclude(const clang::Diagnostic& info, llvm::StringRef message);

}  // namespace oroforge::cxx

#endif
