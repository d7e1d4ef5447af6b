// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What numbers, texts and letters of a script mean.
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
    std::size_t offset;  ///< in the literal
    std::string message;
};

/** `12`, `0xFF`, `1u`, `1.5f`, `10ms`, …; what it means goes to `value`. */
std::optional<LiteralProblem> readNumber(std::string_view number, ast::Value& value);

/** True for `2147483648` and `9223372036854775808ll`, which are numbers after a '-' only; then the least int or llong goes to
    `value`. */
bool readLeast(std::string_view number, ast::Value& value);

/** With its quotes. Reads to its end even if an escape is wrong; tells the first that is. */
std::optional<LiteralProblem> readText(std::string_view quoted, std::string& text);

/** With its quotes. */
std::optional<LiteralProblem> readLetter(std::string_view quoted, char& letter);

}  // namespace RTT::scripting::detail

#endif
