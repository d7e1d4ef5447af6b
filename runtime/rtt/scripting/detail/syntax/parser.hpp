// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Parses a text to a tree. Knows only the grammar: resolves no name and executes nothing.
#ifndef ORO_SCRIPTING_DETAIL_PARSER_HPP
#define ORO_SCRIPTING_DETAIL_PARSER_HPP

#include <rtt/scripting/detail/syntax/ast.hpp>

#include <diag/sink.hpp>

#include <string>

namespace RTT::scripting::detail {

/**
 * Parses the whole text and reports all syntax errors to `sink`; if there are any, the result must not be executed.
 * Messages call the file `name`. Time and memory grow linearly with the text; expressions and blocks nest at most
 * `kMaxNesting` deep; a row of operators has at most `kMaxOperators`, and does not nest. Thread safe; allocates.
 */
ast::Script parse(const std::string& text, const oroforge::diag::FileName& name, oroforge::diag::Sink& sink);

constexpr unsigned kMaxNesting = 200;
constexpr std::size_t kMaxOperators = 100000;

}  // namespace RTT::scripting::detail

#endif
