// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_grammar.hpp>

namespace RTT::scripting::detail {

void TransitionParser::parse(std::vector<ast::Transition>& to) {
    const bool list = tokens_.atWord("transitions");
    tokens_.advance();
    const auto one = [&] {
        to.push_back(transition());
        tokens_.endStatement();
    };
    if (list) {
        grammar_.braces.contents(&Lookahead::stateEndsHere, one);
    } else {
        one();
    }
}

ast::Transition TransitionParser::transition() {
    ast::Transition result;
    result.at = tokens_.place();
    if (!tokens_.atWord("if") && !ahead_.atSelection()) event(result);
    if (tokens_.acceptWord("if")) {
        result.condition = grammar_.expressions.parse();
        tokens_.acceptWord("then");
    }
    result.selection = selection();
    if (result.condition && tokens_.acceptContinuation("else"))
        result.otherwise = std::make_unique<ast::Selection>(selection());
    return result;
}

/** `port(x)`, `peer.operation(a, b)`. */
void TransitionParser::event(ast::Transition& transition) {
    if (!tokens_.atName()) {
        tokens_.failHere("'if', 'select', '{' or an event");
        return;
    }
    do {
        transition.event.push_back(tokens_.name("a name"));
    } while (tokens_.accept(TokenKind::Dot) || tokens_.accept(TokenKind::Colon));
    unsigned height = 0;
    if (tokens_.at(TokenKind::OpenParen)) {
        grammar_.expressions.arguments(transition.arguments, height);
    } else {
        tokens_.fail("'(' and what the event brings along");
    }
}

ast::Selection TransitionParser::selection() {
    ast::Selection result;
    result.at = tokens_.place();
    if (!ahead_.atSelection()) {
        tokens_.fail("'select' and a state, or '{'");
        return result;
    }
    if (tokens_.at(TokenKind::OpenBrace)) result.program = std::make_unique<ast::Block>(grammar_.statements.body());
    if (!ahead_.atSelect()) return result;
    tokens_.advance();
    do {
        result.states.push_back(tokens_.name("the name of a state"));
    } while (tokens_.acceptWord("or"));
    return result;
}

}  // namespace RTT::scripting::detail
