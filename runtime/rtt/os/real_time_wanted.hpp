// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_REAL_TIME_WANTED_HPP
#define ORO_OS_REAL_TIME_WANTED_HPP

#include <rtt/rtt-config.h>

namespace RTT {
namespace os {

class ThreadInterface;

/**
 * Is this a real-time thread, or was it asked to be one? Other than getScheduler() that tells, also where the privilege is
 * missing, what an application is meant to be. Any thread.
 */
RTT_API bool realTimeWanted(const ThreadInterface& thread) noexcept;

namespace detail {

/** For a thread that has its number. Threads beyond the first thousands count by what they got. */
void noteRealTimeWanted(const ThreadInterface& thread, bool wanted) noexcept;

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
