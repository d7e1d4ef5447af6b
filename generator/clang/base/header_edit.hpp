// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Where in the text of a header something may be inserted. Works on the text alone.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_HEADER_EDIT_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_HEADER_EDIT_HPP

#include <cstddef>
#include <optional>
#include <string>

namespace oroforge::cxx {

/// Behind a byte order mark, if there is one.
std::size_t placeForPragmaOnce(const std::string& header);

/// Offset of the line before which "#include <name>" fits: the first #include that no condition but an include guard
/// surrounds, or the line after the guard. Nothing if `name` is included already.
std::optional<std::size_t> placeForInclude(const std::string& header, const std::string& name);

/// The macro of the include guard, if #ifndef, #define and #endif surround all of the text; else empty.
std::string guardOf(const std::string& header);

}  // namespace oroforge::cxx

#endif
