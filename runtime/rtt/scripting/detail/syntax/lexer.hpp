// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Cuts a script into tokens, one at a time, because type names depend on their context.
#ifndef ORO_SCRIPTING_DETAIL_LEXER_HPP
#define ORO_SCRIPTING_DETAIL_LEXER_HPP

#include <rtt/scripting/detail/syntax/token.hpp>

#include <string_view>

namespace RTT::scripting::detail {

/** Cheap to copy, so code looks ahead with a copy. Reports no errors: malformed text is a token, too. */
class Lexer {
public:
    /** The text must outlive it. A byte order mark at its beginning is skipped. */
    explicit Lexer(std::string_view text);

    Token next();
    /** Reads the text at `token` as the name of a type: letters, digits and _ - / < > . [ ] ::. Empty if there is none.
        next() continues after it. */
    Token typeName(const Token& token);

    std::string_view text(const Token& token) const { return text_.substr(token.begin, token.end - token.begin); }

private:
    char at(std::size_t position) const { return position < text_.size() ? text_[position] : '\0'; }
    bool skipBlanks();
    bool skipComment();
    void skipLine();
    std::size_t endOfWord(std::size_t from) const;
    std::size_t endOfTemplate(std::size_t from) const;
    std::size_t endOfTypeName(std::size_t from) const;
    std::size_t endOfNumber(std::size_t from) const;
    std::size_t endOfStray(std::size_t from) const;
    Token word();
    Token quoted(char quote);
    Token punctuation();
    Token take(TokenKind kind, std::size_t end);

    std::string_view text_;
    std::size_t at_ = 0, line_start_ = 0;
    unsigned line_ = 1;
    bool new_line_ = true;
};

}  // namespace RTT::scripting::detail

#endif
