// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Compiles expressions: operators, members, elements, assignments.
#ifndef ORO_SCRIPTING_DETAIL_COMPILE_EXPRESSION_HPP
#define ORO_SCRIPTING_DETAIL_COMPILE_EXPRESSION_HPP

#include <rtt/scripting/detail/compile/unit_part.hpp>

namespace RTT::scripting::detail {

class ExpressionCompiler : private UnitPart {
public:
    explicit ExpressionCompiler(UnitCompiler& unit) : UnitPart(unit) {}

    Operand compile(const ast::Expression& expression);
    /** Compiles a condition. */
    Operand truth(const ast::Expression& condition);
    Operand member(const Operand& of, const ast::Identifier& name);

private:
    Operand literal(const ast::Literal& literal, ast::Place at);
    Operand element(const ast::Index& index, ast::Place at);
    Operand negated(const ast::Unary& operation, const Operand& operand, ast::Place at);
    Operand binary(const ast::Binary& row);
    Operand operation(Operand left, const ast::Binary::Step& step, unsigned first);
    Operand combined(const Operand& left, Operand right, const ast::Binary::Step& step);
    Operand assignment(const ast::Assignment& assignment, ast::Place at);
};

}  // namespace RTT::scripting::detail

#endif
