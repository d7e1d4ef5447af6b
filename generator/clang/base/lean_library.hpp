// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_CLANG_BASE_LEAN_LIBRARY_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_LEAN_LIBRARY_HPP

#include "llvm_compat.hpp"

namespace oroforge::cxx {

/// Takes the comparisons out of std::allocator and its base, which libstdc++ declares as friends. Each vector of another
/// class declares them once more, and the compiler compares each with all those before: 1,000 vectors take a third longer.
/// To be called with each class that is complete.
void dropComparisons(clang::TagDecl& type);

}  // namespace oroforge::cxx

#endif
