// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_VALUE_SYNTAX_HPP
#define OROFORGE_LIVE_VALUE_SYNTAX_HPP

#include <nlohmann/json.hpp>

#include <string>

namespace OCL::live {

/**
 * Reads a value as the console shows it: `3.5`, `0x10`, `true`, `"text"`, `'c'`, `Name` (of an enumerator or of a text
 * without quotes), `{x = 1, y = 2}` and `[1, 2]`. JSON is read, too. Calls nothing, unlike an expression of a script.
 * Throws Failure with the place of what is wrong.
 */
nlohmann::json parseValue(const std::string& text);

}  // namespace OCL::live

#endif
