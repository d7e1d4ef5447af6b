// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Notation of values in manifests, and in C++.
#ifndef OROFORGE_GENERATOR_MODEL_LITERAL_HPP
#define OROFORGE_GENERATOR_MODEL_LITERAL_HPP

#include <string>

namespace oroforge::model {

/// "true" or "false"
bool isBooleanText(const std::string& text);
/// [sign] digits
bool isIntegerText(const std::string& text);
/// [sign] digits [. digits] [e [sign] digits], with a digit before the exponent
bool isNumberText(const std::string& text);

/// A string literal, quotes included. UTF-8 passes through.
std::string stringLiteral(const std::string& text);

/// A value of `type`, as an initialiser: "1.5" of float → "1.5F", text of std::string → a literal.
std::string valueLiteral(const std::string& text, const std::string& type);

}  // namespace oroforge::model

#endif
