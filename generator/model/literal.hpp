// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// How values are written in manifests, and in C++.
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

/// Returns a string literal with its quotes. UTF-8 is kept.
std::string stringLiteral(const std::string& text);

/// Returns an initialiser of `type`: "1.5" of float → "1.5F", text of std::string → a string literal.
std::string valueLiteral(const std::string& text, const std::string& type);

}  // namespace oroforge::model

#endif
