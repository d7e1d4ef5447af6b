// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Headers, and identifiers made of names of packages.
#ifndef OROFORGE_GENERATOR_VIEW_CPP_TEXT_HPP
#define OROFORGE_GENERATOR_VIEW_CPP_TEXT_HPP

#include <string>
#include <vector>

namespace oroforge::view {

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

}  // namespace oroforge::view

#endif
