// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The tokens of a script.
#ifndef ORO_SCRIPTING_DETAIL_TOKEN_HPP
#define ORO_SCRIPTING_DETAIL_TOKEN_HPP

#include <cstddef>
#include <cstdint>

namespace RTT::scripting::detail {

enum class TokenKind : std::uint8_t {
    End,
    Word,      ///< a name or keyword
    TypeWord,  ///< `ints[]`, and `vector<double>` if '(' follows
    Number,    ///< with its suffix, even a wrong one
    Text,      ///< with its quotes
    Letter,    ///< with its quotes
    OpenParen,
    CloseParen,
    OpenBracket,
    CloseBracket,
    OpenBrace,
    CloseBrace,
    Comma,
    Semicolon,
    Dot,
    Colon,  ///< ':' or '::'
    Assign,
    Plus,
    Minus,
    Times,
    Divide,
    Modulo,
    Not,
    And,
    Or,
    Equal,
    Unequal,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    // Malformed text:
    Stray,       ///< bytes that no token begins with
    OpenText,    ///< a text or letter that does not end on its line
    OpenComment  ///< reaches to the end of the script
};

/** A piece of the script; within one line, except for OpenComment. */
struct Token {
    TokenKind kind = TokenKind::End;
    bool newLine = false;  ///< the first token of its line
    unsigned line = 1, column = 1;
    std::size_t begin = 0, end = 0;
};

inline bool isLiteral(TokenKind kind) {
    return kind == TokenKind::Number || kind == TokenKind::Text || kind == TokenKind::Letter;
}

}  // namespace RTT::scripting::detail

#endif
