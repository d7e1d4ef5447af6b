// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_DETAIL_NORMAL_THREAD_HPP
#define RTT_ROSCOMM_DETAIL_NORMAL_THREAD_HPP

#include <pthread.h>
#include <sched.h>

namespace rtt_roscomm::detail {

/** For the first line of a new thread, because what creates it may be a real-time thread. The name has at most 15
    characters. */
inline void becomeNormalThread(const char* name) {
    const sched_param normal{};
    (void)pthread_setschedparam(pthread_self(), SCHED_OTHER, &normal);
    (void)pthread_setname_np(pthread_self(), name);
}

}  // namespace rtt_roscomm::detail

#endif
