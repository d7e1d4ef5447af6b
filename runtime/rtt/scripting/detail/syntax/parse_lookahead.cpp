// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_lookahead.hpp>

namespace RTT::scripting::detail {

bool Lookahead::atDeclaration() const {
    return tokens_.atWord("var") || tokens_.atWord("const") || tokens_.atWord("alias");
}

bool Lookahead::atBreak() const {
    if (!tokens_.atWord("break")) return false;
    const Token next = tokens_.following();
    switch (next.kind) {
        case TokenKind::Semicolon:
        case TokenKind::CloseBrace:
        case TokenKind::End: return true;
        case TokenKind::Word: return next.newLine || tokens_.text(next) == "else" || tokens_.text(next) == "catch";
        default: return next.newLine;
    }
}

bool Lookahead::atDefinition() const {
    for (const std::string_view word :
         {"program", "function", "export", "global", "local", "StateMachine", "RootMachine"})
        if (tokens_.atWordBeforeName(word)) return true;
    return false;
}

bool Lookahead::atFunction() const {
    for (const std::string_view word : {"function", "export", "global", "local"})
        if (tokens_.atWordBeforeName(word)) return true;
    if (!(tokens_.atName() || tokens_.at(TokenKind::TypeWord)) || tokens_.atWord("state")) return false;
    Lexer ahead = tokens_.lexerHere();
    ahead.typeName(tokens_.token());
    const Token name = ahead.next();
    if (name.kind != TokenKind::Word || name.newLine || !tokens_.standsAsName(name)) return false;
    const Token open = ahead.next();
    // Not a function: `While true {` and the like.
    for (const std::string_view value : {"true", "false", "not"})
        if (open.kind == TokenKind::OpenBrace && tokens_.text(name) == value) return false;
    if (open.kind == TokenKind::OpenParen) return !isLiteral(ahead.next().kind);
    return open.kind == TokenKind::OpenBrace;
}

bool Lookahead::atState() const {
    if (tokens_.atWordBeforeName("state")) return true;
    if (!tokens_.atWord("initial") && !tokens_.atWord("final")) return false;
    const Token next = tokens_.following();
    return next.kind == TokenKind::Word && !next.newLine;
}

bool Lookahead::atStateItem() const {
    if (!tokens_.at(TokenKind::Word)) return false;
    const Token next = tokens_.following();
    for (const std::string_view word : {"entry", "run", "handle", "exit", "transitions", "preconditions"})
        if (tokens_.text() == word) return next.kind == TokenKind::OpenBrace;
    return (tokens_.text() == "transition" || tokens_.text() == "precondition") && next.kind == TokenKind::Word;
}

bool Lookahead::atTransitions() const { return tokens_.atWord("transition") || tokens_.atWord("transitions"); }

bool Lookahead::atSelect() const {
    if (!tokens_.atWord("select")) return false;
    const TokenKind next = tokens_.following().kind;
    return next != TokenKind::OpenParen && next != TokenKind::Dot;
}

bool Lookahead::atSelection() const { return tokens_.at(TokenKind::OpenBrace) || atSelect(); }

bool Lookahead::blockEndsHere() const {
    if (in_machine_ && tokens_.token().newLine && (atState() || atStateItem())) return true;
    return machineEndsHere();
}

bool Lookahead::machineEndsHere() const { return atDefinition() && !tokens_.following().newLine; }

bool Lookahead::stateEndsHere() const { return atState() || machineEndsHere(); }

}  // namespace RTT::scripting::detail
