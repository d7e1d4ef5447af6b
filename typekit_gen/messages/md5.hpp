// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TYPEKIT_GEN_MESSAGES_MD5_HPP
#define OROFORGE_TYPEKIT_GEN_MESSAGES_MD5_HPP

#include <string>

namespace oroforge::messages {

/// Returns the MD5 sum (RFC 1321) of bytes in 32 lower-case hexadecimal digits.
std::string md5(const std::string& bytes);

}  // namespace oroforge::messages

#endif
