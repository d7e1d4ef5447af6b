// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Documentation of the user, as generated code shows it.
#ifndef OROFORGE_GENERATOR_MODEL_DOC_TEXT_HPP
#define OROFORGE_GENERATOR_MODEL_DOC_TEXT_HPP

#include <string>
#include <vector>

namespace oroforge::model {

/// The text as lines without leading and trailing blanks, safe inside a // comment.
std::vector<std::string> commentLines(const std::string& text);

/// All lines in one.
std::string oneLine(const std::string& text);

/// What a display shows: the documentation in one line with the unit behind it.
std::string docWithUnit(const std::string& doc, const std::string& unit);

}  // namespace oroforge::model

#endif
