// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Simple fixes of fields: `const` is removed, `const char*` becomes std::string.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_FIELD_FIXES_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_FIELD_FIXES_HPP

#include <clang/base/source_places.hpp>
#include <diag/sink.hpp>

namespace oroforge::cxx {

/// Passes the diagnostics of `from` on to `to`, with fixes where a simple change repairs the field. The field is found
/// by its place, so that code that rejects a type need not know its spelling in the source.
void passOnWithFixes(const diag::Sink& from, const clang::ASTContext& context, const SourcePlaces& places,
                     diag::Sink& to);

}  // namespace oroforge::cxx

#endif
