// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The whole grammar.
#ifndef ORO_SCRIPTING_DETAIL_PARSE_GRAMMAR_HPP
#define ORO_SCRIPTING_DETAIL_PARSE_GRAMMAR_HPP

#include <rtt/scripting/detail/syntax/parse_braces.hpp>
#include <rtt/scripting/detail/syntax/parse_declaration.hpp>
#include <rtt/scripting/detail/syntax/parse_definition.hpp>
#include <rtt/scripting/detail/syntax/parse_expression.hpp>
#include <rtt/scripting/detail/syntax/parse_machine.hpp>
#include <rtt/scripting/detail/syntax/parse_statement.hpp>
#include <rtt/scripting/detail/syntax/parse_transition.hpp>

namespace RTT::scripting::detail {

/** The rules, a class for each subject, and what they share. Rules use each other, so each can reach all of them. */
struct Grammar {
    Grammar(std::string_view text, const oroforge::diag::FileName& name, oroforge::diag::Sink& sink)
        : tokens(text, name, sink) {}

    TokenReader tokens;
    Lookahead ahead{tokens};
    Nesting nesting{tokens};
    Braces braces{*this};
    ExpressionParser expressions{*this};
    DeclarationParser declarations{*this};
    StatementParser statements{*this};
    DefinitionParser definitions{*this};
    TransitionParser transitions{*this};
    MachineParser machines{*this};
};

inline Rules::Rules(Grammar& grammar) : grammar_(grammar), tokens_(grammar.tokens), ahead_(grammar.ahead) {}

}  // namespace RTT::scripting::detail

#endif
