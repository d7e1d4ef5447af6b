// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_SUPPORT_TEXT_DIFF_HPP
#define OROFORGE_TESTS_SUPPORT_TEXT_DIFF_HPP

#include <string>
#include <vector>

namespace oroforge::test {

std::vector<std::string> splitLines(const std::string& text);

/// `diff -u` of two texts with three lines of context; empty if they are equal.
std::string unifiedDiff(const std::string& expected, const std::string& actual, const std::string& name);

}  // namespace oroforge::test

#endif
