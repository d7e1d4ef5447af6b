// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Turns text into C++ source.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_CPP_WORDS_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_CPP_WORDS_HPP

#include <string>

#include <model/shown_name.hpp>

namespace oroforge::typekit {

/// Returns a string literal with its quotes.
std::string cppString(const std::string& text);

/// Returns string literals, one for each line of the text and in a line of its own.
std::string cppLines(const std::string& text);

/// Replaces every character but letters, digits and underscores by an underscore.
std::string cppLetters(const std::string& text);

/// Returns the same as an identifier, which does not begin with a digit.
std::string cppIdentifier(const std::string& text);

using model::cppShown;

}  // namespace oroforge::typekit

#endif
