// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_CLANG_BASE_LEAN_LIBRARY_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_LEAN_LIBRARY_HPP

#include "llvm_compat.hpp"

namespace oroforge::cxx {

/// Removes the comparisons that libstdc++ declares as friends of std::allocator and its base. Each vector of another
/// class declares them again, and the compiler compares each with all earlier ones: 1,000 vectors take a third longer.
/// Call it with each class that is complete.
void dropComparisons(clang::TagDecl& type);

}  // namespace oroforge::cxx

#endif
