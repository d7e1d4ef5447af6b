// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "source_check.hpp"

#include "../fuzzing.hpp"

#include <clang/Basic/LangOptions.h>
#include <clang/Lex/Lexer.h>

namespace oroforge::fuzz {

void checkSource(const std::string& text) {
    clang::LangOptions language;
    language.CPlusPlus = language.CPlusPlus11 = language.CPlusPlus14 = language.CPlusPlus17 = true;
    language.LineComment = language.Bool = true;
    clang::Lexer lexer(clang::SourceLocation(), language, text.data(), text.data(), text.data() + text.size());
    std::string open;
    clang::Token token;
    for (lexer.LexFromRawLexer(token); token.isNot(clang::tok::eof); lexer.LexFromRawLexer(token)) {
        const clang::tok::TokenKind kind = token.getKind();
        require(kind != clang::tok::unknown, "generated text is made of tokens", text);
        if (kind == clang::tok::l_paren) open += ')';
        if (kind == clang::tok::l_square) open += ']';
        if (kind == clang::tok::l_brace) open += '}';
        if (kind != clang::tok::r_paren && kind != clang::tok::r_square && kind != clang::tok::r_brace) continue;
        const char closing = kind == clang::tok::r_paren ? ')' : kind == clang::tok::r_square ? ']' : '}';
        require(!open.empty() && open.back() == closing, "brackets belong together", text);
        open.pop_back();
    }
    require(open.empty(), "brackets are closed", text);
}

}  // namespace oroforge::fuzz
