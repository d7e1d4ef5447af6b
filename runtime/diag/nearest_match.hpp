// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// "Did you mean …?"
#ifndef OROFORGE_DIAG_NEAREST_MATCH_HPP
#define OROFORGE_DIAG_NEAREST_MATCH_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace oroforge::diag {

/// The number of insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`. Case is ignored.
std::size_t editDistance(const std::string& a, const std::string& b);

/// The candidate closest to `name`, if `name` may be a misspelling of it (about one error in three letters). The first
/// of equally close ones wins.
std::optional<std::string> nearestMatch(const std::string& name, const std::vector<std::string>& candidates);

/// "; did you mean 'x'?", to append to a message; empty if no candidate is close.
std::string didYouMean(const std::string& name, const std::vector<std::string>& candidates);

/// "'a', 'b' or 'c'", to put after "expected".
std::string oneOf(const std::vector<std::string>& choices);

}  // namespace oroforge::diag

#endif
