// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_LOCATED_LOG_HPP
#define ORO_INTERNAL_LOCATED_LOG_HPP

#include <rtt/Logger.hpp>

#include <string>

namespace RTT {
namespace internal {

/**
 * Logs a text that begins with the place it is about, `file:line:column: `. Nothing is put in front, so that editors find the
 * place; everything else of it is as of a line of that level. Any thread; real-time safe where Logger is.
 */
RTT_API void logLocated(LoggerLevel level, const std::string& text);

}  // namespace internal
}  // namespace RTT

#endif
