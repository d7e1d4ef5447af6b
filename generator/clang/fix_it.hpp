// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Repairs that need no thought: `const` goes, `const char*` becomes std::string, a header gets its `#pragma once`.
#ifndef OROFORGE_GENERATOR_CLANG_FIX_IT_HPP
#define OROFORGE_GENERATOR_CLANG_FIX_IT_HPP

#include <diag/sink.hpp>

#include "source_places.hpp"

namespace oroforge::cxx {

/// Hands the diagnostics of `from` on to `to`, with fixes where the field they stand at can be repaired by the letter.
/// The field is found by its place, so that whoever rejects a type need not know how it is spelled in the source.
void passOnWithFixes(const diag::Sink& from, const clang::ASTContext& context, const SourcePlaces& places,
                     diag::Sink& to);

/// What the compiler proposes, in our terms. Nothing if a part of it lies in a macro.
std::vector<diag::Fix> fixesOf(llvm::ArrayRef<clang::FixItHint> hints, const clang::SourceManager& sources,
                               const clang::LangOptions& language, const SourcePlaces& places);

}  // namespace oroforge::cxx

#endif
