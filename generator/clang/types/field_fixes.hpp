// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Repairs of fields that need no thought: `const` goes, `const char*` becomes std::string.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_FIELD_FIXES_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_FIELD_FIXES_HPP

#include <clang/base/source_places.hpp>
#include <diag/sink.hpp>

namespace oroforge::cxx {

/// Hands the diagnostics of `from` on to `to`, with fixes where the field they stand at can be repaired by the letter.
/// The field is found by its place, so that whoever rejects a type need not know how it is spelled in the source.
void passOnWithFixes(const diag::Sink& from, const clang::ASTContext& context, const SourcePlaces& places,
                     diag::Sink& to);

}  // namespace oroforge::cxx

#endif
