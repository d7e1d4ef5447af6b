// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_rules.hpp>

namespace RTT::scripting::detail {

bool Parser::atTransitions() const { return atWord("transition") || atWord("transitions"); }

/** `transition …`, `transitions { … }`. */
void Parser::transitions(std::vector<ast::Transition>& to) {
    const bool list = atWord("transitions");
    advance();
    const auto one = [&] {
        to.push_back(transition());
        endStatement();
    };
    if (list) {
        inBraces(&Parser::stateEndsHere, one);
    } else {
        one();
    }
}

ast::Transition Parser::transition() {
    ast::Transition result;
    result.at = place();
    if (!atWord("if") && !atSelection()) event(result);
    if (acceptWord("if")) {
        result.condition = expression();
        acceptWord("then");
    }
    result.selection = selection();
    if (result.condition && acceptContinuation("else"))
        result.otherwise = std::make_unique<ast::Selection>(selection());
    return result;
}

/** `port(x)`, `peer.operation(a, b)`. */
void Parser::event(ast::Transition& transition) {
    if (!atName()) {
        failHere("'if', 'select', '{' or an event");
        return;
    }
    do {
        transition.event.push_back(name("a name"));
    } while (accept(TokenKind::Dot) || accept(TokenKind::Colon));
    unsigned height = 0;
    if (at(TokenKind::OpenParen)) {
        arguments(transition.arguments, height);
    } else {
        fail("'(' and what the event brings along");
    }
}

/** True at the keyword `select`, which can also be the name of an event. */
bool Parser::atSelect() const {
    if (!atWord("select")) return false;
    const TokenKind next = following().kind;
    return next != TokenKind::OpenParen && next != TokenKind::Dot;
}

bool Parser::atSelection() const { return at(TokenKind::OpenBrace) || atSelect(); }

/** `select A or B`, `{ … } select A`, `{ … }`. */
ast::Selection Parser::selection() {
    ast::Selection result;
    result.at = place();
    if (!atSelection()) {
        fail("'select' and a state, or '{'");
        return result;
    }
    loops_ = 0;
    if (at(TokenKind::OpenBrace)) result.program = std::make_unique<ast::Block>(body());
    if (!atSelect()) return result;
    advance();
    do {
        result.states.push_back(name("the name of a state"));
    } while (acceptWord("or"));
    return result;
}

}  // namespace RTT::scripting::detail
