// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Text to tree. Knows the grammar only: no name is looked up, nothing is executed.
#ifndef ORO_SCRIPTING_DETAIL_PARSER_HPP
#define ORO_SCRIPTING_DETAIL_PARSER_HPP

#include <rtt/scripting/detail/syntax/ast.hpp>

#include <diag/sink.hpp>

#include <string>

namespace RTT::scripting::detail {

/** The whole text; every syntax error in it is reported to `sink`, then what is returned must not be executed. `name` stands
    for the file in messages. Time and memory grow linearly with the text; expressions and blocks nest at most
    `kMaxNesting` deep; a row of operators has at most `kMaxOperators`, and does not nest. Thread safe; allocates. */
ast::Script parse(const std::string& text, const oroforge::diag::FileName& name, oroforge::diag::Sink& sink);

constexpr unsigned kMaxNesting = 200;
constexpr std::size_t kMaxOperators = 100000;

}  // namespace RTT::scripting::detail

#endif
