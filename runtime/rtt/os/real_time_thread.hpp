// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_REAL_TIME_THREAD_HPP
#define ORO_OS_REAL_TIME_THREAD_HPP

#include <rtt/rtt-config.h>

namespace RTT {
namespace os {

/** True if the calling thread is scheduled as a real-time thread now. Makes a system call that never waits. */
RTT_API bool inRealTimeThread() noexcept;

}  // namespace os
}  // namespace RTT
#endif
