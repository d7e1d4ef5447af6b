// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_FIND_CALLS_HPP
#define ORO_SCRIPTING_DETAIL_FIND_CALLS_HPP

#include <rtt/scripting/detail/syntax/ast.hpp>

#include <vector>

namespace RTT::scripting::detail {

/** A possible call. Names without argument list may be values; constructors of known types are not included. */
struct FoundCall {
    const ast::Name* name;
    ast::Place at;
    bool certain;  ///< made whenever the statement is executed
    bool ignored;  ///< its value is ignored
};

/** All possible calls, in the order in which they are made. They refer to the tree. */
std::vector<FoundCall> callsIn(const ast::Statement& statement);
/** The same for a block; none of these is certain. */
std::vector<FoundCall> callsIn(const ast::Block& block);
/** Calls `visit` with each expression whose value the script ignores: the expression itself, or the operands of its
    `&&`. */
template <class Visit>
void forIgnored(const ast::Expression& expression, Visit visit) {
    visit(expression);
    const auto* const row = std::get_if<ast::Binary>(&expression.what);
    if (!row) return;
    for (const ast::Binary::Step& step : row->steps)
        if (step.op != "&&") return;
    forIgnored(*row->first, visit);
    for (const ast::Binary::Step& step : row->steps) forIgnored(*step.right, visit);
}

}  // namespace RTT::scripting::detail

#endif
