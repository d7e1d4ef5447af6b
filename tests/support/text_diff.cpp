// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "text_diff.hpp"

#include <algorithm>
#include <sstream>

namespace oroforge::test {

namespace {

struct Edit {
    char kind;  // ' ', '-' or '+'
    std::string text;
};

/// Longest common subsequence by the quadratic table: goldens are hundreds of lines, not millions.
std::vector<Edit> edits(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    std::vector<std::vector<unsigned>> length(a.size() + 1, std::vector<unsigned>(b.size() + 1, 0));
    for (std::size_t i = a.size(); i-- > 0;) {
        for (std::size_t j = b.size(); j-- > 0;) {
            length[i][j] = a[i] == b[j] ? length[i + 1][j + 1] + 1 : std::max(length[i + 1][j], length[i][j + 1]);
        }
    }
    std::vector<Edit> result;
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() || j < b.size()) {
        if (i < a.size() && j < b.size() && a[i] == b[j]) {
            result.push_back({' ', a[i]});
            ++i, ++j;
        } else if (j == b.size() || (i < a.size() && length[i + 1][j] >= length[i][j + 1])) {
            result.push_back({'-', a[i++]});
        } else {
            result.push_back({'+', b[j++]});
        }
    }
    return result;
}

std::string range(std::size_t start, std::size_t count) {
    return std::to_string(count == 0 ? start : start + 1) + "," + std::to_string(count);
}

}  // namespace

std::vector<std::string> splitLines(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    if (!text.empty() && text.back() != '\n') lines.back() += "  (no end of line)";
    return lines;
}

std::string unifiedDiff(const std::string& expected, const std::string& actual, const std::string& name) {
    if (expected == actual) return {};
    const std::vector<Edit> all = edits(splitLines(expected), splitLines(actual));
    const std::size_t context = 3;
    std::string out = "--- " + name + "\n+++ actual\n";
    std::size_t oldLine = 0;
    std::size_t newLine = 0;
    for (std::size_t i = 0; i < all.size();) {
        // A hunk starts where a change lies within the context ahead.
        std::size_t change = i;
        while (change < all.size() && all[change].kind == ' ') ++change;
        if (change == all.size()) break;
        const std::size_t begin = std::max(i, change > context ? change - context : 0);
        oldLine += begin - i;
        newLine += begin - i;
        std::size_t last = change;
        for (std::size_t k = change; k < all.size() && k <= last + 2 * context; ++k) {
            if (all[k].kind != ' ') last = k;
        }
        const std::size_t end = std::min(all.size(), last + context + 1);
        std::size_t olds = 0;
        std::size_t news = 0;
        std::string body;
        for (std::size_t k = begin; k < end; ++k) {
            olds += all[k].kind != '+';
            news += all[k].kind != '-';
            body += all[k].kind + all[k].text + "\n";
        }
        out += "@@ -" + range(oldLine, olds) + " +" + range(newLine, news) + " @@\n" + body;
        oldLine += olds;
        newLine += news;
        i = end;
    }
    return out;
}

}  // namespace oroforge::test
