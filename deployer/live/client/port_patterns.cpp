// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "port_patterns.hpp"

#include <algorithm>

#include <fnmatch.h>

namespace oroforge::live_client {

PortPatterns::PortPatterns(const std::vector<std::string>& words) : words_(words) {
    for (std::string pattern : words) {
        if (!pattern.empty() && pattern[0] == '/') {
            pattern.erase(0, 1);
            std::replace(pattern.begin(), pattern.end(), '/', '.');
        }
        patterns_.push_back(pattern);
    }
}

bool PortPatterns::matches(const std::string& pattern, const std::string& port) {
    if (fnmatch(pattern.c_str(), port.c_str(), 0) == 0) return true;
    return port.size() > pattern.size() && port[pattern.size()] == '.' && port.compare(0, pattern.size(), pattern) == 0;
}

bool PortPatterns::matches(const std::string& port) const {
    return patterns_.empty() || std::any_of(patterns_.begin(), patterns_.end(),
                                            [&](const std::string& pattern) { return matches(pattern, port); });
}

std::vector<std::string> PortPatterns::unmatched(const std::vector<std::string>& ports) const {
    std::vector<std::string> none;
    for (std::size_t i = 0; i != patterns_.size(); ++i)
        if (std::none_of(ports.begin(), ports.end(),
                         [&](const std::string& port) { return matches(patterns_[i], port); }))
            none.push_back(words_[i]);
    return none;
}

}  // namespace oroforge::live_client
