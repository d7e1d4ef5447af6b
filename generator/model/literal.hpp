// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Notation of values that manifests and C++ share.
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

}  // namespace oroforge::model

#endif
