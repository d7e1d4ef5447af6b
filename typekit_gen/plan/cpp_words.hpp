// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Text as C++ source.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_CPP_WORDS_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_CPP_WORDS_HPP

#include <string>

#include <model/shown_name.hpp>

namespace oroforge::typekit {

/// A string literal with its quotes.
std::string cppString(const std::string& text);

/// Text made of letters, digits and underscores: what is neither becomes an underscore.
std::string cppLetters(const std::string& text);

/// The same as a name of its own, which does not begin with a digit.
std::string cppIdentifier(const std::string& text);

using model::cppShown;

}  // namespace oroforge::typekit

#endif
