// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_DRAIN_HPP
#define RTT_DETAIL_LOG_DRAIN_HPP

#include <rtt/os/Semaphore.hpp>

#include <atomic>
#include <mutex>
#include <pthread.h>

namespace RTT {
namespace detail {

/** A thread of ordinary priority that empties the queue of the log whenever it is woken. */
class LogDrain {
public:
    /** Does nothing if it runs already. If it cannot be created, threads that are not real-time empty the queue. */
    void start();
    /** Waits for the end of the thread. */
    void stop();
    /** Around fork(): a child of the process has no such thread. */
    void beforeFork() { mutex_.lock(); }
    void afterFork(bool inChild);
    /** Real-time safe. */
    void wake() noexcept {
        // Release: the thread that takes the flag sees earlier lines. Only the one that sets it makes a system call.
        if (!due_.exchange(true, std::memory_order_acq_rel)) sleep_.signal();
    }

private:
    static void* run(void* self);

    os::Semaphore sleep_{0};
    std::atomic<bool> due_{false};
    std::atomic<bool> end_{false};
    std::mutex mutex_;  // for start and stop
    bool running_ = false;
    pthread_t thread_{};
};

/** Has fatal signals without a handler write the rest of the log before they end the process. */
void writeLogOnFatalSignals();

}  // namespace detail
}  // namespace RTT
#endif
