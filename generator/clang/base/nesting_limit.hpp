// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Ends the reading of texts that are nested so deeply that the compiler, which calls itself for each level, would run out of stack.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_NESTING_LIMIT_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_NESTING_LIMIT_HPP

#include "llvm_compat.hpp"

namespace oroforge::cxx {

/// clang limits brackets and the depth of instances itself; neither counts '<', nor operators without brackets.
class NestingLimit {
public:
    /// Each word in turn. From the one on that is too much, all become the end of the text, after one fatal error.
    void take(const clang::Token& token, clang::DiagnosticsEngine& engine);

private:
    const char* tooMuch(const clang::Token& token);

    unsigned angles_ = 0;  ///< '<' that wait for their '>', comparisons included
    unsigned words_ = 0;   ///< since the last one that ends a part
    bool wasName_ = false;
    bool ended_ = false;
};

}  // namespace oroforge::cxx

#endif
