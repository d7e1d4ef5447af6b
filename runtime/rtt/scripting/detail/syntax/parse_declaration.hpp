// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Declarations of variables, constants, aliases and parameters.
#ifndef ORO_SCRIPTING_DETAIL_PARSE_DECLARATION_HPP
#define ORO_SCRIPTING_DETAIL_PARSE_DECLARATION_HPP

#include <rtt/scripting/detail/syntax/parse_rules.hpp>

namespace RTT::scripting::detail {

class DeclarationParser : private Rules {
public:
    explicit DeclarationParser(Grammar& grammar) : Rules(grammar) {}

    /** `var T a, b(2), c = 3`, `const T a = 1`, `alias T a = b`. */
    ast::StatementPtr declaration();
    /** `param T a, b`. */
    ast::StatementPtr parameters();
    /** The `(3)` of `var strings s(3)`, or null. */
    ast::ExpressionPtr sizeHint();

private:
    ast::Declarator declarator(ast::Declaration::Kind kind);
};

}  // namespace RTT::scripting::detail

#endif
