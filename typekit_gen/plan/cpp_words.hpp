// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Text as C++ source.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_CPP_WORDS_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_CPP_WORDS_HPP

#include <string>

namespace oroforge::typekit {

/// A string literal with its quotes.
std::string cppString(const std::string& text);

/// A name made of letters, digits and underscores.
std::string cppIdentifier(const std::string& text);

/// The name of a type without the leading "::" of the names in it.
std::string cppShown(const std::string& type);

}  // namespace oroforge::typekit

#endif
