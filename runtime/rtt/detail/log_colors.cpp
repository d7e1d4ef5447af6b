// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_colors.hpp>

#include <rtt/detail/log_format.hpp>
#include <rtt/os/terminal_buffer.hpp>

#include <cstdlib>
#include <cstring>
#include <iostream>
#include <unistd.h>

namespace RTT::detail {

namespace {

const char* colorOf(LoggerLevel level) noexcept {
    switch (level) {
        case Fatal:
        case Critical: return "\033[1;37;41m";
        case Error: return "\033[1;31m";
        case Warning: return "\033[33m";
        case Info: return "\033[32m";
        case Debug: return "\033[36m";
        case RealTime: return "\033[35m";
        case Never: break;
    }
    return "\033[1m";
}

/** When the library is loaded, before a program may have put a buffer of its own there. */
const std::streambuf* const ownBuffer = std::cerr.rdbuf();

bool environmentForbids() {
    const char* const none = std::getenv("NO_COLOR");
    const char* const terminal = std::getenv("TERM");
    return (none && *none) || !terminal || !*terminal || std::strcmp(terminal, "dumb") == 0;
}

}  // namespace

void LogColors::begin(When when) { when_ = when == Auto && environmentForbids() ? Never : when; }

bool LogColors::on(const std::ostream& console) const noexcept {
    if (when_ == Never || &console != &std::cerr) return false;
    std::streambuf* const buffer = std::cerr.rdbuf();
    if (buffer != ownBuffer && !dynamic_cast<os::TerminalBuffer*>(buffer)) return false;
    return when_ == Always || isatty(STDERR_FILENO) != 0;
}

void LogColors::paint(const std::string& line, LoggerLevel level, std::string& out) {
    const std::size_t tag = line.find(' ') + 1;
    out.assign(line, 0, tag).append(colorOf(level)).append(line, tag, kTagSize).append("\033[0m");
    out.append(line, tag + kTagSize, std::string::npos);
}

}  // namespace RTT::detail
