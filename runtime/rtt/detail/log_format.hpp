// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_FORMAT_HPP
#define RTT_DETAIL_LOG_FORMAT_HPP

#include <rtt/Logger.hpp>

#include <string>

namespace RTT {
namespace detail {

/** "[ Warning]", always ten characters. */
const char* levelTag(LoggerLevel level) noexcept;

/** Replaces `line` by `<seconds>.<ms> [ LEVEL ][module] text`, without an end of line. */
void formatLine(std::string& line, nsecs sinceReference, LoggerLevel level, const std::string& module,
                const std::string& text);

/** Compiler that built the runtime, "GCC 12.2". */
std::string compilerName();

}  // namespace detail
}  // namespace RTT
#endif
