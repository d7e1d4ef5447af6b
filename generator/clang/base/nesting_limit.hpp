// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Stops at text that is nested so deeply that the compiler, which recurses for each level, would run out of stack.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_NESTING_LIMIT_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_NESTING_LIMIT_HPP

#include "llvm_compat.hpp"

namespace oroforge::cxx {

/// clang itself limits brackets and the depth of instances, but neither '<' nor operators without brackets.
class NestingLimit {
public:
    /// Takes each word in turn. After the limit it reports one fatal error, and makes every word the end of the text.
    void take(const clang::Token& token, clang::DiagnosticsEngine& engine);

private:
    const char* tooMuch(const clang::Token& token);

    unsigned angles_ = 0;  ///< '<' without a '>' so far, comparisons included
    unsigned words_ = 0;   ///< since the last word that ends a part
    bool wasName_ = false;
    bool ended_ = false;
};

}  // namespace oroforge::cxx

#endif
