// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Checks the values of constants.
#ifndef OROFORGE_TYPEKIT_GEN_MESSAGES_PARSE_CONSTANT_HPP
#define OROFORGE_TYPEKIT_GEN_MESSAGES_PARSE_CONSTANT_HPP

#include <string>

namespace oroforge::messages {

/// Returns "" if a constant of the type can have the value; otherwise what is wrong with it.
std::string faultOfConstant(const std::string& type, const std::string& value);

}  // namespace oroforge::messages

#endif
