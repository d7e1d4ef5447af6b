// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What the parser made of a script, written as a script again: all parentheses and braces are there, one line for all. Parsed
/// once more, it gives the same text.
#ifndef TESTS_UNIT_SCRIPTING_AST_TEXT_HPP
#define TESTS_UNIT_SCRIPTING_AST_TEXT_HPP

#include <rtt/scripting/detail/syntax/ast.hpp>

#include <string>

namespace tests {

std::string textOf(const RTT::scripting::detail::ast::Expression& expression);
std::string textOf(const RTT::scripting::detail::ast::Statement& statement);
std::string textOf(const RTT::scripting::detail::ast::Item& item);
/// The items, with " ; " between them.
std::string textOf(const RTT::scripting::detail::ast::Script& script);

/// Parses, and textOf(); or all that is reported, as it is printed.
std::string parsed(const std::string& script);
/// All that is reported, as it is printed; "" if nothing is.
std::string complaints(const std::string& script);

}  // namespace tests

#endif
