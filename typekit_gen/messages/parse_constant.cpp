// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <messages/parse_constant.hpp>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace oroforge::messages {

namespace {

struct Range {
    const char* type;
    std::int64_t least;
    std::uint64_t most;
};

template <class T>
constexpr Range rangeOf(const char* type) {
    return {type, std::numeric_limits<T>::min(), static_cast<std::uint64_t>(std::numeric_limits<T>::max())};
}

constexpr Range kRanges[] = {
    rangeOf<std::int8_t>("int8"),   rangeOf<std::int8_t>("byte"),
    rangeOf<std::uint8_t>("uint8"), rangeOf<std::uint8_t>("char"),
    rangeOf<std::int16_t>("int16"), rangeOf<std::uint16_t>("uint16"),
    rangeOf<std::int32_t>("int32"), rangeOf<std::uint32_t>("uint32"),
    rangeOf<std::int64_t>("int64"), {"uint64", 0, std::numeric_limits<std::uint64_t>::max()},
};

std::string faultOfNumber(const Range& range, const std::string& value) {
    char* end = nullptr;
    errno = 0;
    const bool isNegative = value.front() == '-';
    const std::int64_t low = isNegative ? std::strtoll(value.c_str(), &end, 10) : 0;
    const std::uint64_t high = isNegative ? 0 : std::strtoull(value.c_str(), &end, 10);
    if (*end != '\0' || end == value.c_str()) return "'" + value + "' is not a whole number in decimal digits";
    if (errno == ERANGE || low < range.least || high > range.most)
        return value + " does not fit into " + range.type + ", which holds " + std::to_string(range.least) + " to " +
               std::to_string(range.most);
    return "";
}

}  // namespace

std::string faultOfConstant(const std::string& type, const std::string& value) {
    if (type == "string") return "";
    if (type == "time" || type == "duration") return "there are no constants of type " + type;
    if (value.empty()) return "no value behind '='";
    if (type == "bool") {
        for (const char* word : {"True", "False", "0", "1"})
            if (value == word) return "";
        return "'" + value + "' is not a bool; write True or False";
    }
    for (const Range& range : kRanges)
        if (type == range.type) return faultOfNumber(range, value);
    char* end = nullptr;
    std::strtod(value.c_str(), &end);
    return *end == '\0' ? "" : "'" + value + "' is not a number";
}

}  // namespace oroforge::messages
