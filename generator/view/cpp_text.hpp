// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Names of headers, and identifiers made from package names.
#ifndef OROFORGE_GENERATOR_VIEW_CPP_TEXT_HPP
#define OROFORGE_GENERATOR_VIEW_CPP_TEXT_HPP

#include <string>
#include <vector>

namespace oroforge::view {

/// Returns the path by which sources include a header of the package: "tank/t.hpp" for "include/tank/t.hpp",
/// "tank/models/t.hpp" for "src/models/t.hpp" of package tank. cmake/OrocosGenerate.cmake has the same rule.
std::string includeName(const std::string& header, const std::string& package);

/// Returns the standard headers that declare standard names in these types, sorted: "cstdint", "string", "vector".
std::vector<std::string> standardHeaders(const std::vector<std::string>& types);

/// "my-pkg.x" → "my_pkg_x"
std::string identifier(const std::string& packageName);
/// Makes the first letter a capital: "mypkg" → "Mypkg".
std::string className(const std::string& packageName);
/// Returns the text as letters, digits and '_' in upper case, for include guards.
std::string guardName(const std::string& text);

}  // namespace oroforge::view

#endif
