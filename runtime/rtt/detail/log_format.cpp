// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_format.hpp>

#include <rtt/detail/log_clock.hpp>

#include <charconv>
#include <cstring>

namespace RTT::detail {

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

namespace {

/** `12.345`, rounded. */
char* formatSeconds(char* at, nsecs time) noexcept {
    if (time < 0) *at++ = '-';
    const auto amount = static_cast<unsigned long long>(time);
    const unsigned long long rounded = ((time < 0 ? 0 - amount : amount) + 500000) / 1000000;  // ms
    at = std::to_chars(at, at + 20, rounded / 1000).ptr;
    *at++ = '.';
    for (unsigned digit = 100; digit != 0; digit /= 10) *at++ = static_cast<char>('0' + rounded / digit % 10);
    return at;
}

}  // namespace

std::size_t formatStart(char (&out)[kLongestStart], const LogParts& parts, TimeStyle style) noexcept {
    static_assert(kLongestWallTime + kTagSize + 2 <= kLongestStart);
    char* at = style.wall ? formatWallTime(out, parts.wall, style.utcOffset) : formatSeconds(out, parts.time);
    *at++ = ' ';
    std::memcpy(at, levelTag(parts.level), kTagSize);
    at += kTagSize;
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

namespace {

bool isControl(char c) noexcept { return (static_cast<unsigned char>(c) < 0x20U && c != '\t') || c == '\x7f'; }

/** Terminals also obey U+0080 to U+009F. */
bool isLongControl(std::string_view text, std::size_t at) noexcept {
    return text[at] == '\xC2' && at + 1 < text.size() && static_cast<unsigned char>(text[at + 1]) < 0xA0U;
}

}  // namespace

std::size_t findControl(std::string_view text, std::size_t at) noexcept {
    while (at < text.size() && !isControl(text[at]) && !isLongControl(text, at)) ++at;
    return at;
}

std::size_t formatControl(char (&out)[kLongestSpelling], std::string_view text, std::size_t& taken) noexcept {
    static constexpr char digits[] = "0123456789abcdef";
    taken = isControl(text[0]) ? 1 : 2;
    const auto code = static_cast<unsigned char>(text[taken - 1]);
    out[0] = '\\';
    out[1] = 'x';
    out[2] = digits[code >> 4U];
    out[3] = digits[code & 15U];
    return kLongestSpelling;
}

std::string compilerName() {
#if defined(__clang__)
    return "Clang " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__);
#else
    return "GCC " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__);
#endif
}

}  // namespace RTT::detail
