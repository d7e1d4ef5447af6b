// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_WAITING_HPP
#define ORO_INTERNAL_DETAIL_WAITING_HPP

#include <rtt/internal/DeferredCalls.hpp>

#include <pthread.h>

#include <mutex>
#include <vector>

namespace RTT {
namespace internal {
namespace detail {

/**
 * A thread that waits until others have told components of new samples, or have returned from the callbacks of ports. Lives
 * on its stack. Two that wait for what the other one is doing must not go on doing so, so nobody waits for a thread that
 * is in here: its callbacks are passed over, its deferred calls are taken from it.
 */
class RTT_API Waiting {
public:
    Waiting();
    ~Waiting();
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;

    static bool has(pthread_t thread);
    /** Gives up the deferred calls with this argument in all threads that are in here, other than this one: those that wait
        and those that are being made. Returns their number. */
    static unsigned takeOver(const void* argument);

    // The same for this thread's own, which others may be taking over.
    static unsigned cancel(const void* argument);
    static unsigned making(const void* argument);
    static unsigned abandon(const void* argument);

private:
    static std::mutex& mutex();
    static std::vector<Waiting*>& all();

    const pthread_t thread_ = pthread_self();
    DeferredCalls& calls_;
    // What this thread had to call when it came here. It lies further down its stack, and the thread does not touch it
    // without the lock until it has left; what it executes meanwhile has lists of its own.
    DeferredCalls::Batch parked_;
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
