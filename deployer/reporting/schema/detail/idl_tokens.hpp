// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEMA_IDL_TOKENS_HPP
#define OROFORGE_SCHEMA_IDL_TOKENS_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace oroforge::schema {

struct IdlToken {
    enum Kind : std::uint8_t { Name, Number, Text, Character, Sign, End };
    Kind kind = End;
    std::string_view text;  ///< a name may have parts: "a::b"; of a text or character, with its quotation marks
    std::size_t line = 1;
};

/** The tokens of IDL, with an End behind the last one. Comments, lines of the preprocessor, and the lines between the
    files of ros2idl are left out. They refer to the text. False, with the reason and the line, if a token is wrong. */
bool readTokens(std::string_view text, std::vector<IdlToken>& tokens, std::string& why);

}  // namespace oroforge::schema

#endif
