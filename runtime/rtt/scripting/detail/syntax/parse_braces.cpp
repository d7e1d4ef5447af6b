// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_grammar.hpp>

namespace RTT::scripting::detail {

Braces::Braces(Grammar& grammar) : Rules(grammar), nesting_(grammar.nesting) {}

/** Accepts '{' and stores it in `open`, unless it is missing. False if failed. */
bool Braces::openBraces(Token& open) {
    open = tokens_.token();
    if (tokens_.accept(TokenKind::OpenBrace)) return true;
    open = Token();
    const bool forgotten = tokens_.token().newLine && tokens_.token().kind != TokenKind::End;
    tokens_.fail("'{'");
    if (!forgotten) {
        tokens_.recoverAtBrace();
        return tokens_.at(TokenKind::OpenBrace) && openBraces(open);
    }
    tokens_.forget();
    return true;
}

void Braces::closeBraces(const Token& open) {
    if (tokens_.failed() || tokens_.accept(TokenKind::CloseBrace) || open.kind != TokenKind::OpenBrace) return;
    const bool known = assumed_at_ == tokens_.token().begin;  // reported for an inner block
    const ast::Place openPlace{open.line, open.column};
    if (tokens_.at(TokenKind::End)) {
        if (auto* error = tokens_.fail("'}'", "OPS009")) error->note(tokens_.location(openPlace), "opened here");
        return;
    }
    ++assumed_closed_;
    assumed_at_ = tokens_.token().begin;
    if (known) return;
    if (auto* error = tokens_.failWith("OPS009", "found " + tokens_.found() + ", expected '}' before it"))
        error->note(tokens_.location(openPlace), "opened here");
    tokens_.forget();
}

void Braces::skipStray() {
    if (assumed_closed_ > 0) {
        --assumed_closed_;
    } else {
        tokens_.failWith("OPS009", "found '}' without a '{' before it");
        tokens_.forget();
    }
    tokens_.advance();
}

}  // namespace RTT::scripting::detail
