// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_FIND_CALLS_HPP
#define ORO_SCRIPTING_DETAIL_FIND_CALLS_HPP

#include <rtt/scripting/detail/syntax/ast.hpp>

#include <vector>

namespace RTT::scripting::detail {

/** What may be a call: constructors of known types are none, names without argument list may be values. */
struct FoundCall {
    const ast::Name* name;
    ast::Place at;
    bool certain;  ///< made whenever the statement is executed
    bool ignored;  ///< nobody looks at its value
};

/** All of them, in the order in which they are made. They refer to the tree. */
std::vector<FoundCall> callsIn(const ast::Statement& statement);
/** None of these is certain. */
std::vector<FoundCall> callsIn(const ast::Block& block);
/** Calls `visit` with each expression whose value the script does not look at: the expression itself, or the operands of
    its `&&`. */
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
