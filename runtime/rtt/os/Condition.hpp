// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_CONDITION_HPP
#define ORO_OS_CONDITION_HPP

#include <rtt/os/Mutex.hpp>

#include <pthread.h>

namespace RTT {
namespace os {

/**
 * Lets threads wait until another thread announces a change. The caller of a wait must hold the mutex; the wait
 * releases it and locks it again before it returns. Waits block and are not real-time safe; broadcast() does not block.
 */
class RTT_API Condition {
public:
    Condition();
    ~Condition();
    Condition(const Condition&) = delete;
    Condition& operator=(const Condition&) = delete;

    /** May also return without a broadcast: test the condition again. */
    void wait(Mutex& mutex);

    /** Waits until pred() is true. */
    template <class Predicate>
    void wait(Mutex& mutex, Predicate& pred) {
        while (!pred()) wait(mutex);
    }

    /** Wakes every waiter. */
    void broadcast();

    /**
     * Waits at most until the monotonic time `deadline` (nanoseconds, as rtos_get_time_ns()). Returns false if that
     * time has come, true if the thread was woken before.
     */
    bool wait_until(Mutex& mutex, nsecs deadline);

private:
    pthread_cond_t condition_;
};

}  // namespace os
}  // namespace RTT
#endif
