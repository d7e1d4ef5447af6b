// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <diag/nearest_match.hpp>

#include <algorithm>
#include <cctype>

namespace oroforge::diag {

namespace {

bool sameLetter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

}  // namespace

std::size_t editDistance(const std::string& a, const std::string& b) {
    // rows[i % 3][j] = distance between the first i letters of a and the first j of b.
    std::vector<std::vector<std::size_t>> rows(3, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        auto& row = rows[i % 3];
        const auto& above = rows[(i - 1) % 3];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = above[j - 1] + (sameLetter(a[i - 1], b[j - 1]) ? 0 : 1);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
            const bool swapped = i > 1 && j > 1 && sameLetter(a[i - 1], b[j - 2]) && sameLetter(a[i - 2], b[j - 1]);
            if (swapped) row[j] = std::min(row[j], rows[(i - 2) % 3][j - 2] + 1);
        }
    }
    return rows[a.size() % 3][b.size()];
}

std::optional<std::string> nearestMatch(const std::string& name, const std::vector<std::string>& candidates) {
    std::optional<std::string> best;
    std::size_t limit = std::max<std::size_t>(1, (name.size() + 1) / 3) + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = editDistance(name, candidate);
        // Words of which every letter differs are not similar, however short.
        if (distance >= limit || distance >= std::max(name.size(), candidate.size())) continue;
        limit = distance;
        best = candidate;
    }
    return best;
}

std::string didYouMean(const std::string& name, const std::vector<std::string>& candidates) {
    const auto match = nearestMatch(name, candidates);
    return match ? "; did you mean '" + *match + "'?" : std::string();
}

std::string oneOf(const std::vector<std::string>& choices) {
    std::string text;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (i != 0) text += i + 1 == choices.size() ? " or " : ", ";
        text += "'" + choices[i] + "'";
    }
    return text;
}

}  // namespace oroforge::diag
