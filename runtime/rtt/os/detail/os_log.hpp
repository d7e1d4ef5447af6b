// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_OS_DETAIL_OS_LOG_HPP
#define RTT_OS_DETAIL_OS_LOG_HPP

#include <string>  // who logs composes text
#include <string_view>

/** @file How this layer writes to the log; os/log_hook.hpp says where that goes. */
namespace RTT {
namespace os {
namespace detail {

// The numbers of RTT::LoggerLevel.
enum LogLevel { LogCritical = 2, LogError = 3, LogWarning = 4, LogInfo = 5, LogDebug = 6 };

void log(LogLevel level, const char* module, std::string_view text);
/** To be called in a new thread. */
void beginRealTimeThread();

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
