// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_rules.hpp>

namespace RTT::scripting::detail {

/** `{ … }`, or one statement. */
ast::Block Parser::block() {
    if (at(TokenKind::OpenBrace)) return body();
    ast::Block result;
    result.at = result.end = place();
    Level level(*this);
    if (!level) return result;
    const std::size_t begin = token().begin;
    if (atWord("else") || atWord("catch")) failHere("a statement");
    ast::StatementPtr only = statement();
    if (!atWord("else") && !atWord("catch")) explainNameAfter(only.get(), requireEnd());
    if (!failed()) result.statements.push_back(std::move(only));
    recover(begin, true);
    return result;
}

ast::Block Parser::loopBody() {
    ++loops_;
    ast::Block result = block();
    --loops_;
    return result;
}

/** `{ … }` and nothing else. */
ast::Block Parser::body() {
    ast::Block result;
    result.at = place();
    result.end = inBraces(&Parser::blockEndsHere, [&] {
        ast::StatementPtr next = statement();
        endAfter(next);
        if (!failed()) result.statements.push_back(std::move(next));
    });
    return result;
}

/** Accepts `else` and `catch`, which may be on a new line and after a ';'. */
bool Parser::acceptContinuation(std::string_view word) {
    if (at(TokenKind::Semicolon)) {
        const Token next = following();
        if (next.kind == TokenKind::Word && text(next) == word) advance();
    }
    return acceptWord(word);
}

/** Accepts '{' and stores it in `open`, unless it is missing. False if failed. */
bool Parser::openBraces(Token& open) {
    open = token();
    if (accept(TokenKind::OpenBrace)) return true;
    open = Token();
    const bool forgotten = token().newLine && token().kind != TokenKind::End;
    fail("'{'");
    if (!forgotten) {
        recoverAtBrace();
        return at(TokenKind::OpenBrace) && openBraces(open);
    }
    forget();
    return true;
}

/** True at something that cannot be in a block, because a '}' is missing. */
bool Parser::blockEndsHere() const {
    if (in_machine_ && token().newLine && (atState() || atStateItem())) return true;
    return machineEndsHere();
}

void Parser::closeBraces(const Token& open) {
    if (failed() || accept(TokenKind::CloseBrace) || open.kind != TokenKind::OpenBrace) return;
    const bool known = assumed_at_ == token().begin;  // reported for an inner block
    const ast::Place openPlace{open.line, open.column};
    if (at(TokenKind::End)) {
        if (auto* error = fail("'}'", "OPS009")) error->note(location(openPlace), "opened here");
        return;
    }
    ++assumed_closed_;
    assumed_at_ = token().begin;
    if (known) return;
    if (auto* error = failWith("OPS009", "found " + found() + ", expected '}' before it"))
        error->note(location(openPlace), "opened here");
    forget();
}

}  // namespace RTT::scripting::detail
