// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_REAL_TIME_WANTED_HPP
#define ORO_OS_REAL_TIME_WANTED_HPP

#include <rtt/rtt-config.h>

namespace RTT {
namespace os {

class ThreadInterface;

/**
 * True if this is a real-time thread, or was meant to be one. Unlike getScheduler(), it gives the intended result even
 * where the privilege is missing. May be called from any thread.
 */
RTT_API bool realTimeWanted(const ThreadInterface& thread) noexcept;

namespace detail {

/** Must be called after the thread got its number. For numbers above some thousands, the actual scheduler counts. */
void noteRealTimeWanted(const ThreadInterface& thread, bool wanted) noexcept;

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
