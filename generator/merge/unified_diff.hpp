// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_MERGE_UNIFIED_DIFF_HPP
#define OROFORGE_GENERATOR_MERGE_UNIFIED_DIFF_HPP

#include <string>

namespace oroforge::merge {

/// As `diff -u` prints it and `patch` takes it; nothing if both are equal. An empty text stands for no file.
std::string unifiedDiff(const std::string& before, const std::string& after, const std::string& file);

}  // namespace oroforge::merge

#endif
