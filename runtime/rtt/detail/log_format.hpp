// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_FORMAT_HPP
#define RTT_DETAIL_LOG_FORMAT_HPP

#include <rtt/Logger.hpp>

#include <string>
#include <string_view>

namespace RTT {
namespace detail {

/** What a line is made of. */
struct LogParts {
    nsecs time;  // since the reference time
    LoggerLevel level;
    std::string_view module, text;
    std::size_t cut = 0;  // characters of the text that were left out
    bool bare = false;    // the text alone is the line
};

/** "[ Warning]", always ten characters. */
const char* levelTag(LoggerLevel level) noexcept;

/** `<seconds>.<ms> [ LEVEL ][` into `out`; returns its size. Neither allocates nor locks. */
constexpr std::size_t kLongestStart = 48;
std::size_t formatStart(char (&out)[kLongestStart], nsecs time, LoggerLevel level) noexcept;
/** ` ... (12 characters cut)` likewise; nothing if none are. */
constexpr std::size_t kLongestMark = 64;
std::size_t formatMark(char (&out)[kLongestMark], std::size_t cut) noexcept;

/** Calls `append(text, size)` for each part of `<seconds>.<ms> [ LEVEL ][module] text`, with the end of line. */
template <class Append>
void composeLine(const LogParts& parts, Append append) {
    char start[kLongestStart], mark[kLongestMark];
    if (!parts.bare) {
        append(start, formatStart(start, parts.time, parts.level));
        append(parts.module.data(), parts.module.size());
        append("] ", std::size_t(2));
    }
    append(parts.text.data(), parts.text.size());
    append(mark, formatMark(mark, parts.cut));
    append("\n", std::size_t(1));
}

/** Compiler that built the runtime, "GCC 12.2". */
std::string compilerName();

}  // namespace detail
}  // namespace RTT
#endif
