// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_UNIT_OS_REAL_TIME_THREAD_HPP
#define OROFORGE_TESTS_UNIT_OS_REAL_TIME_THREAD_HPP

#include <pthread.h>
#include <thread>

namespace oroforge::test {

/** The calling thread becomes a real-time thread of low priority; false if the process may not do that. */
inline bool becomeRealTime() {
    sched_param parameters{};
    parameters.sched_priority = 1;
    return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

/** Executes f() in a real-time thread; false if there can be none. */
template <class F>
bool inRealTimeThread(F f) {
    bool done = false;
    std::thread([&] { done = becomeRealTime() && (f(), true); }).join();
    return done;
}

}  // namespace oroforge::test
#endif
