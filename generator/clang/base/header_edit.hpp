// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds where text can be inserted into a header. Works on the text alone.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_HEADER_EDIT_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_HEADER_EDIT_HPP

#include <cstddef>
#include <optional>
#include <string>

namespace oroforge::cxx {

/// Returns the place after a byte order mark, if there is one.
std::size_t placeForPragmaOnce(const std::string& header);

/// Returns the offset of the line before which "#include <name>" fits: the first #include outside all conditions but an
/// include guard, or the line after the guard. Returns nothing if `name` is included already.
std::optional<std::size_t> placeForInclude(const std::string& header, const std::string& name);

/// Returns the macro of the include guard if #ifndef, #define and #endif surround the whole text; else empty.
std::string guardOf(const std::string& header);

}  // namespace oroforge::cxx

#endif
