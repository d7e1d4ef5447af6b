// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_LOCATED_LOG_HPP
#define ORO_INTERNAL_LOCATED_LOG_HPP

#include <rtt/Logger.hpp>

#include <string>

namespace RTT {
namespace internal {

/**
 * Logs a text that begins with a place, `file:line:column: `, with nothing in front, so that editors find the place.
 * Otherwise it is a normal line of that level. Any thread; as real-time safe as Logger.
 */
RTT_API void logLocated(LoggerLevel level, const std::string& text);

}  // namespace internal
}  // namespace RTT

#endif
