// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Expressions: assignment → binary (eleven precedences) → unary → operand (with members and indices) → primary.
// Precedences are those of the original: && binds weaker than ||, % than *.
#ifndef ORO_SCRIPTING_DETAIL_PARSE_EXPRESSION_HPP
#define ORO_SCRIPTING_DETAIL_PARSE_EXPRESSION_HPP

#include <rtt/scripting/detail/syntax/parse_rules.hpp>

namespace RTT::scripting::detail {

class ExpressionParser : private Rules {
public:
    explicit ExpressionParser(Grammar& grammar) : Rules(grammar) {}

    /** Parses an expression; null if failed. */
    ast::ExpressionPtr parse() { return assignment().expression; }
    /** Parses arguments with their parentheses; `height` becomes their depth. False if failed. */
    bool arguments(ast::Expressions& to, unsigned& height);

private:
    /** An expression with its depth and its first letter, because `at` of an operation is its operator. */
    struct Tree {
        ast::ExpressionPtr expression;
        unsigned height = 0;
        ast::Place begin;
    };
    Tree assignment();
    Tree binary(int least);
    Tree unary();
    Tree operand();
    Tree primary();
    Tree parenthesis();
    Tree literal();
    Tree named();
    template <class What>
    Tree tree(ast::Place at, ast::Place begin, unsigned height, What what);
};

}  // namespace RTT::scripting::detail

#endif
