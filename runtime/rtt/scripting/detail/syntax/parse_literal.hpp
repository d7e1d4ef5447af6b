// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reads the literals of a script.
#ifndef ORO_SCRIPTING_DETAIL_PARSE_LITERAL_HPP
#define ORO_SCRIPTING_DETAIL_PARSE_LITERAL_HPP

#include <rtt/scripting/detail/syntax/ast.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace RTT::scripting::detail {

struct LiteralProblem {
    const char* code;
    std::size_t offset;  ///< the place in the literal
    std::string message;
};

/** Reads `12`, `0xFF`, `1u`, `1.5f`, `10ms` and so on into `value`. */
std::optional<LiteralProblem> readNumber(std::string_view number, ast::Value& value);

/** True for `2147483648` and `9223372036854775808ll`, which are valid only after a '-'; then `value` is the least int
    or llong. */
bool readLeast(std::string_view number, ast::Value& value);

/** Reads a text with its quotes, to its end even if an escape is wrong; returns the first error. */
std::optional<LiteralProblem> readText(std::string_view quoted, std::string& text);

/** Reads a letter with its quotes. */
std::optional<LiteralProblem> readLetter(std::string_view quoted, char& letter);

}  // namespace RTT::scripting::detail

#endif
