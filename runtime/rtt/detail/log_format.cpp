// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_format.hpp>

#include <cstdio>

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

void formatLine(std::string& line, nsecs sinceReference, LoggerLevel level, const std::string& module,
                const std::string& text) {
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.3f", nsecs_to_Seconds(sinceReference));
    line.assign(seconds).append(" ").append(levelTag(level)).append("[").append(module).append("] ").append(text);
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
