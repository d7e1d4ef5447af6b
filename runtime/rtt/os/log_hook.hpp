// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_LOG_HOOK_HPP
#define ORO_OS_LOG_HOOK_HPP

#include <rtt/rtt-config.h>

#include <string_view>

namespace RTT {
namespace os {

/** Writes one line to the log; `level` is a RTT::LoggerLevel. */
typedef void (*LogHook)(int level, const char* module, std::string_view text);

/**
 * Sets where messages of the os layer go, which does not know the Logger. The Logger calls it when the library is
 * loaded. Until then, warnings and errors go to the standard error stream.
 */
RTT_API void setLogHook(LogHook hook) noexcept;

/** Called in each new os::Thread that is a real-time thread, before it executes anything. */
typedef void (*RealTimeThreadHook)();
RTT_API void setRealTimeThreadHook(RealTimeThreadHook hook) noexcept;

}  // namespace os
}  // namespace RTT
#endif
