// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_WAITING_HPP
#define ORO_INTERNAL_DETAIL_WAITING_HPP

#include <rtt/internal/flow/deferred_calls.hpp>

#include <pthread.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

namespace RTT {
namespace internal {
namespace detail {

/**
 * Exists while a thread waits until others have signalled new samples to components, or have returned from callbacks of
 * ports. Lives on its stack. Two threads must not wait for each other, so none waits for a thread that is in here: its
 * callbacks are passed over, its deferred calls are taken from it.
 */
class RTT_API Waiting {
public:
    Waiting();
    ~Waiting();
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;

    /** Another value whenever the wait of a thread in here may be over. */
    static std::uint32_t now() noexcept { return changes_.load(std::memory_order_acquire); }
    /** Sleeps until now() differs from `seen`. With `executesMessages` the components that this thread is executing
        execute their messages meanwhile, unless it is inside a Guard. */
    void sleep(std::uint32_t seen, bool executesMessages) const;
    /** Call it after a change that others may be waiting for. Real-time safe; makes a system call only if a thread
        waits. */
    static void mayBeOver() noexcept {
        if (__builtin_expect(number_ != 0, 0)) wakeAll();
    }

    static bool has(pthread_t thread);
    /** Cancels the deferred calls with this argument, waiting or in progress, in all other threads that are in here.
        Returns their number. */
    static unsigned takeOver(const void* argument);

    // As the functions of DeferredCalls, for this thread's own calls, which others may be taking over.
    static unsigned cancel(const void* argument);
    static unsigned making(const void* argument);
    static unsigned abandon(const void* argument);

private:
    static std::mutex& mutex();
    static std::vector<Waiting*>& all();
    static void wakeAll() noexcept;

    static std::atomic<std::uint32_t> number_;   // of the threads in here
    static std::atomic<std::uint32_t> changes_;  // where they sleep

    const pthread_t thread_ = pthread_self();
    DeferredCalls& calls_;
    // The calls that this thread had to make when it came here. The thread does not touch them without the lock until
    // it has left; code that it executes meanwhile has lists of its own.
    DeferredCalls::Batch parked_;
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
