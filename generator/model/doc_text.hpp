// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Prepares the user's documentation for generated code.
#ifndef OROFORGE_GENERATOR_MODEL_DOC_TEXT_HPP
#define OROFORGE_GENERATOR_MODEL_DOC_TEXT_HPP

#include <string>
#include <vector>

namespace oroforge::model {

/// Returns the lines without leading and trailing blanks, safe inside a // comment.
std::vector<std::string> commentLines(const std::string& text);

std::string oneLine(const std::string& text);

/// Returns the documentation in one line, with the unit at the end, as displays show it.
std::string docWithUnit(const std::string& doc, const std::string& unit);

}  // namespace oroforge::model

#endif
