// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_FORMAT_HPP
#define RTT_DETAIL_LOG_FORMAT_HPP

#include <rtt/Logger.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace RTT {
namespace detail {

/** The parts of a line. */
struct LogParts {
    LoggerLevel level;
    std::string_view module, text;
    std::size_t cut = 0;      // number of characters that were cut off
    bool bare = false;        // the line is the text alone
    bool forReceiver = true;  // false if a receiver logged it
    nsecs time = 0;           // since the reference time
    std::int64_t wall = 0;    // ns since 1970
};

/** How a line shows its time. */
struct TimeStyle {
    bool wall;
    int utcOffset;  // seconds
};

/** "[ Warning]", always ten characters. */
constexpr std::size_t kTagSize = 10;
const char* levelTag(LoggerLevel level) noexcept;

/** `<time> [ LEVEL ][` into `out`; returns its size. Neither allocates nor locks. */
constexpr std::size_t kLongestStart = 48;
std::size_t formatStart(char (&out)[kLongestStart], const LogParts& parts, TimeStyle style) noexcept;
/** ` ... (12 characters cut)` likewise; nothing if `cut` is 0. */
constexpr std::size_t kLongestMark = 64;
std::size_t formatMark(char (&out)[kLongestMark], std::size_t cut) noexcept;

/** The position, from `at` on, of a control character to escape, any but the tab; the size of `text` if none. */
std::size_t findControl(std::string_view text, std::size_t at) noexcept;
/** Escapes the control character at the beginning of `text`, such as `\x1b`; `taken` gets its size in bytes. */
constexpr std::size_t kLongestSpelling = 4;
std::size_t formatControl(char (&out)[kLongestSpelling], std::string_view text, std::size_t& taken) noexcept;

/**
 * Appends text of users so that no part of it looks like a line of the log or controls the terminal. Text after a line
 * end is indented, or without `indented` the line end becomes `\x0a`; others are escaped. Does not allocate.
 */
template <class Append>
void appendHarmless(std::string_view text, bool indented, Append append) {
    for (std::size_t begin = 0;;) {
        const std::size_t end = findControl(text, begin);
        append(text.data() + begin, end - begin);
        if (end == text.size()) return;
        char spelling[kLongestSpelling];
        std::size_t taken = 1;
        if (indented && text[end] == '\n') {
            append("\n", std::size_t(1));
            if (end + 1 != text.size()) append("    ", std::size_t(4));
        } else {
            append(spelling, formatControl(spelling, text.substr(end), taken));
        }
        begin = end + taken;
    }
}

/** Calls `append(text, size)` for each part of `<time> [ LEVEL ][module] text`, with the end of line. */
template <class Append>
void composeLine(const LogParts& parts, TimeStyle style, Append append) {
    char start[kLongestStart], mark[kLongestMark];
    if (!parts.bare) {
        append(start, formatStart(start, parts, style));
        appendHarmless(parts.module, false, append);
        append("] ", std::size_t(2));
    }
    if (parts.bare)
        append(parts.text.data(), parts.text.size());
    else
        appendHarmless(parts.text, true, append);
    append(mark, formatMark(mark, parts.cut));
    append("\n", std::size_t(1));
}

/** The compiler that built the runtime, such as "GCC 12.2". */
std::string compilerName();

}  // namespace detail
}  // namespace RTT
#endif
