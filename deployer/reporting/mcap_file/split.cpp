// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "split.hpp"

#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace OCL::recording {
namespace {

/** A number and what follows it. */
std::pair<double, std::string> quantity(const std::string& text) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    while (*end == ' ') ++end;
    return {number, end};
}

}  // namespace

bool readSplit(const std::string& text, Split& split) {
    split = {};
    if (text.empty()) return true;
    if (readSize(text, split.bytes)) return true;
    const auto [number, unit] = quantity(text);
    static const std::vector<std::pair<std::string, double>> times = {{"s", 1}, {"min", 60}, {"h", 3600}};
    for (const auto& [name, factor] : times)
        if (name == unit && isTime(number * factor)) {
            split.nanoseconds = static_cast<std::uint64_t>(std::ceil(number * factor * 1e9));
            return true;
        }
    return false;
}

bool readSize(const std::string& text, std::uint64_t& bytes) {
    const auto [number, unit] = quantity(text);
    static const std::vector<std::pair<std::string, double>> sizes = {{"kB", 1e3}, {"MB", 1e6}, {"GB", 1e9}};
    for (const auto& [name, factor] : sizes)
        if (name == unit && number > 0 && number * factor < 1e18) {
            bytes = static_cast<std::uint64_t>(std::ceil(number * factor));
            return true;
        }
    return false;
}

}  // namespace OCL::recording
