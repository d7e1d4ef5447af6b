// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_TOKEN_HPP
#define OROFORGE_LIVE_TOKEN_HPP

#include <string>
#include <string_view>

namespace OCL::live {

/** 128 random bits as 32 hexadecimal digits; empty if the kernel has none. */
std::string newToken();

/** The first line of a file that nobody but its owner may read. Empty, with the reason, if it is not that, or the token
    has fewer than 16 or more than 256 characters, or others than letters, digits, '-', '_', '.' and '~'. */
std::string readToken(const std::string& file, std::string& error);

/** Takes the same time wherever the two differ. */
bool areEqual(std::string_view given, std::string_view expected);

}  // namespace OCL::live

#endif
