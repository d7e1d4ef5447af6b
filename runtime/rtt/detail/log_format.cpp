// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_format.hpp>

#include <charconv>
#include <cstring>

namespace RTT {
namespace detail {

const char* levelTag(LoggerLevel level) noexcept {
    switch (level) {
        case Never: return "[ Never  ]";
        case Fatal: return "[ FATAL  ]";
        case Critical: return "[CRITICAL]";
        case Error: return "[ ERROR  ]";
        case Warning: return "[ Warning]";
        case Info: return "[ Info   ]";
        case Debug: return "[ Debug  ]";
        case RealTime: return "[RealTime]";
    }
    return "[ ?      ]";
}

std::size_t formatStart(char (&out)[kLongestStart], nsecs time, LoggerLevel level) noexcept {
    char* at = out;
    if (time < 0) *at++ = '-';
    const auto amount = static_cast<unsigned long long>(time);
    const unsigned long long rounded = ((time < 0 ? 0 - amount : amount) + 500000) / 1000000;  // ms
    at = std::to_chars(at, out + 24, rounded / 1000).ptr;
    *at++ = '.';
    for (unsigned digit = 100; digit != 0; digit /= 10) *at++ = static_cast<char>('0' + rounded / digit % 10);
    *at++ = ' ';
    std::memcpy(at, levelTag(level), 10);
    at += 10;
    *at++ = '[';
    return static_cast<std::size_t>(at - out);
}

std::size_t formatMark(char (&out)[kLongestMark], std::size_t cut) noexcept {
    if (cut == 0) return 0;
    std::memcpy(out, " ... (", 6);
    char* const at = std::to_chars(out + 6, out + 30, cut).ptr;
    std::memcpy(at, " characters cut)", 16);
    return static_cast<std::size_t>(at + 16 - out);
}

std::string compilerName() {
#if defined(__clang__)
    return "Clang " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__);
#else
    return "GCC " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__);
#endif
}

}  // namespace detail
}  // namespace RTT
