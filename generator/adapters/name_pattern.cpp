// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <adapters/name_pattern.hpp>

#include <algorithm>
#include <cctype>

namespace oroforge::adapters {

std::vector<NamePart> partsOf(const std::string& pattern) {
    std::vector<NamePart> parts;
    std::size_t at = 0;
    while (at < pattern.size()) {
        std::size_t end = at;
        if (pattern[at] != '$') {
            end = std::min(pattern.find('$', at), pattern.size());
            parts.push_back({pattern.substr(at, end - at), false});
            at = end;
            continue;
        }
        const bool inBraces = pattern.compare(at, 2, "${") == 0;
        const std::size_t begin = at + (inBraces ? 2 : 1);
        end = begin;
        while (end < pattern.size() &&
               (std::isalnum(static_cast<unsigned char>(pattern[end])) != 0 || pattern[end] == '_'))
            ++end;
        parts.push_back({pattern.substr(begin, end - begin), true});
        at = end;
        if (!inBraces) continue;
        if (at < pattern.size() && pattern[at] == '}')
            ++at;
        else
            parts.back().text.clear();
    }
    return parts;
}

std::string expanded(const std::string& pattern, const std::map<std::string, std::string>& variables) {
    std::string result;
    for (const NamePart& part : partsOf(pattern)) result += part.isVariable ? variables.at(part.text) : part.text;
    return result;
}

}  // namespace oroforge::adapters
