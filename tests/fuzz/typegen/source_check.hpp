// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef TESTS_FUZZ_TYPEGEN_SOURCE_CHECK_HPP
#define TESTS_FUZZ_TYPEGEN_SOURCE_CHECK_HPP

#include <string>

namespace oroforge::fuzz {

/// Ends the program if the text is not C++ at first sight: literals and comments end, brackets belong together.
void checkSource(const std::string& text);

}  // namespace oroforge::fuzz

#endif
