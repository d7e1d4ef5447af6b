// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_OS_LOG_HPP
#define ORO_OS_OS_LOG_HPP

#include <string>  // for callers, which compose text
#include <string_view>

/** @file Logging for this layer; os/log_hook.hpp says where it goes. */
namespace RTT {
namespace os {
namespace detail {

// The numbers of RTT::LoggerLevel.
enum LogLevel { LogCritical = 2, LogError = 3, LogWarning = 4, LogInfo = 5, LogDebug = 6 };

void log(LogLevel level, const char* module, std::string_view text);
/** Must be called in each new real-time thread. */
void beginRealTimeThread();

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
