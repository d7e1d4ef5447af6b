// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Pieces of C++ made from what the user wrote.
#ifndef OROFORGE_GENERATOR_VIEW_CPP_TEXT_HPP
#define OROFORGE_GENERATOR_VIEW_CPP_TEXT_HPP

#include <string>
#include <vector>

#include <model/package.hpp>

namespace oroforge::view {

/// A string literal, quotes included. UTF-8 passes through.
std::string stringLiteral(const std::string& text);

/// The text as lines without leading and trailing blanks, safe inside a // comment.
std::vector<std::string> commentLines(const std::string& text);

/// The first sentence or line, in one line.
std::string oneLine(const std::string& text);

/// A value of `type`, as an initialiser: "1.5" of float → "1.5F", text of std::string → a literal.
std::string valueLiteral(const std::string& text, const std::string& type);

/// How sources include a header of the package: "tank/t.hpp" for "include/tank/t.hpp", "tank/models/t.hpp" for
/// "src/models/t.hpp" of package tank. The same rule as in cmake/OrocosGenerate.cmake.
std::string includeName(const std::string& header, const std::string& package);

/// Standard headers that declare the standard names in these types, sorted: "cstdint", "string", "vector".
std::vector<std::string> standardHeaders(const std::vector<std::string>& types);

/// "my-pkg.x" → "my_pkg_x"
std::string identifier(const std::string& packageName);
/// First letter upper-cased: "mypkg" → "Mypkg"
std::string className(const std::string& packageName);
/// Letters, digits and '_' in upper case: for include guards.
std::string guardName(const std::string& text);

/// "tank" of "tank::Controller", "" of "Controller".
std::string namespaceOf(const std::string& qualified);
/// "Controller" of "tank::Controller".
std::string lastName(const std::string& qualified);

}  // namespace oroforge::view

#endif
