// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/unified_diff.hpp>

#include <algorithm>
#include <vector>

namespace oroforge::merge {

namespace {

constexpr std::size_t kContext = 3;

using Lines = std::vector<std::string>;

Lines linesOf(const std::string& text) {
    Lines lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t newline = text.find('\n', at);
        const std::size_t end = newline == std::string::npos ? text.size() : newline + 1;
        lines.push_back(text.substr(at, end - at));
        at = end;
    }
    return lines;
}

struct Step {
    char mark;  ///< ' ', '-' or '+'
    const std::string* line;
};

/// Returns the fewest steps from one text to the other; common lines at both ends are skipped.
std::vector<Step> stepsBetween(const Lines& before, const Lines& after) {
    std::size_t front = 0, back = 0;
    const std::size_t least = std::min(before.size(), after.size());
    while (front < least && before[front] == after[front]) ++front;
    while (back < least - front && before[before.size() - 1 - back] == after[after.size() - 1 - back]) ++back;
    const std::size_t n = before.size() - front - back, m = after.size() - front - back;
    std::vector<std::vector<unsigned>> common(n + 1, std::vector<unsigned>(m + 1, 0));
    for (std::size_t i = n; i-- > 0;)
        for (std::size_t j = m; j-- > 0;)
            common[i][j] = before[front + i] == after[front + j] ? common[i + 1][j + 1] + 1
                                                                 : std::max(common[i + 1][j], common[i][j + 1]);
    std::vector<Step> steps;
    for (std::size_t i = 0; i != front; ++i) steps.push_back({' ', &before[i]});
    for (std::size_t i = 0, j = 0; i < n || j < m;) {
        if (i < n && j < m && before[front + i] == after[front + j]) {
            steps.push_back({' ', &before[front + i]});
            ++i, ++j;
        } else if (i < n && (j == m || common[i + 1][j] >= common[i][j + 1])) {
            steps.push_back({'-', &before[front + i++]});
        } else {
            steps.push_back({'+', &after[front + j++]});
        }
    }
    for (std::size_t i = before.size() - back; i != before.size(); ++i) steps.push_back({' ', &before[i]});
    return steps;
}

std::string rangeText(std::size_t first, std::size_t count) {
    // An empty range is numbered by the line before it.
    return std::to_string(count == 0 ? first - 1 : first) + (count == 1 ? "" : "," + std::to_string(count));
}

}  // namespace

std::string unifiedDiff(const std::string& before, const std::string& after, const std::string& file) {
    if (before == after) return {};
    const Lines old = linesOf(before), fresh = linesOf(after);
    const std::vector<Step> steps = stepsBetween(old, fresh);
    std::string result = before.empty() ? "--- /dev/null\n" : "--- a/" + file + "\n";
    result += after.empty() ? "+++ /dev/null\n" : "+++ b/" + file + "\n";
    std::size_t oldLine = 1, newLine = 1;
    for (std::size_t at = 0; at < steps.size();) {
        const auto changed = [&](std::size_t from) {
            while (from < steps.size() && steps[from].mark == ' ') ++from;
            return from;
        };
        const std::size_t first = changed(at);
        if (first == steps.size()) break;
        const std::size_t begin = first - std::min(kContext, first - at);
        std::size_t end = first;
        for (std::size_t next = first; next < steps.size() && next <= end + 2 * kContext; next = changed(end)) {
            end = next;
            while (end < steps.size() && steps[end].mark != ' ') ++end;
        }
        end = std::min(end + kContext, steps.size());
        oldLine += begin - at, newLine += begin - at;
        std::size_t oldCount = 0, newCount = 0;
        std::string lines;
        for (std::size_t i = begin; i != end; ++i) {
            if (steps[i].mark != '+') ++oldCount;
            if (steps[i].mark != '-') ++newCount;
            lines += steps[i].mark + *steps[i].line;
            if (lines.back() != '\n') lines += "\n\\ No newline at end of file\n";
        }
        result += "@@ -" + rangeText(oldLine, oldCount) + " +" + rangeText(newLine, newCount) + " @@\n" + lines;
        oldLine += oldCount, newLine += newCount;
        at = end;
    }
    return result;
}

}  // namespace oroforge::merge
