// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_MERGE_UNIFIED_DIFF_HPP
#define OROFORGE_GENERATOR_MERGE_UNIFIED_DIFF_HPP

#include <string>

namespace oroforge::merge {

/// Returns the output of `diff -u`, for `patch`; nothing if both are equal. An empty text means that there is no file.
std::string unifiedDiff(const std::string& before, const std::string& after, const std::string& file);

}  // namespace oroforge::merge

#endif
