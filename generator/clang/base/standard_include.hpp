// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Which header is missing where the compiler does not know a name of the standard library.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_STANDARD_INCLUDE_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_STANDARD_INCLUDE_HPP

#include <string>

#include "llvm_compat.hpp"

namespace oroforge::cxx {

/// "#include <vector>" for an error about std::vector, `message` being its words; empty if it is about something else.
std::string missingInclude(const clang::Diagnostic& info, llvm::StringRef message);

}  // namespace oroforge::cxx

#endif
