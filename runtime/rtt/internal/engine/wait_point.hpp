// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_WAIT_POINT_HPP
#define ORO_INTERNAL_WAIT_POINT_HPP

#include <rtt/rtt-config.h>

#include <atomic>
#include <cstdint>

namespace RTT {
namespace internal {

/**
 * Where threads wait for a notification of an engine.
 *
 * A waiter: `auto ticket = point.ticket(); if (!condition) point.wait(ticket);` A notifier changes the condition and
 * then calls notify().
 *
 * One word holds the number of notifications and, in its lowest bit, whether a thread sleeps. No wake-up is lost: the
 * waiter sets the bit only if the number is still that of its ticket, in one atomic operation. A notification before
 * that makes it fail; a later one finds the bit. If the notification came before the ticket, the waiter has seen its
 * condition: the acquire load of the ticket pairs with the release of the addition. A thread that went to sleep costs
 * at most one system call: the notifier that finds the bit clears it.
 */
class RTT_API WaitPoint {
public:
    std::uint32_t ticket() const { return word_.load(std::memory_order_acquire) & ~kAsleep; }
    /** Sleeps until a notify() after ticket(), or until the monotonic time in ns. Blocks. */
    void wait(std::uint32_t ticket, std::int64_t deadline = INT64_MAX);
    /**
     * Announces a sleeper, for a thread that waits here and elsewhere (os::detail::futexWaitAny). False if there was a
     * notify() after ticket(); otherwise the thread may sleep while word() is `asleep`.
     */
    bool arm(std::uint32_t ticket, std::uint32_t& asleep);
    const std::atomic<std::uint32_t>& word() const { return word_; }
    /** Wakes all waiters. Real-time safe; makes a system call only if a thread sleeps. */
    void notify() {
        if (word_.fetch_add(kStep) & kAsleep) wake();
    }
    /** Keeps waiters with an older ticket from falling asleep, but wakes none. */
    void mark() { word_.fetch_add(kStep); }

private:
    static constexpr std::uint32_t kAsleep = 1, kStep = 2;
    void wake();

    std::atomic<std::uint32_t> word_{0};
};

}  // namespace internal
}  // namespace RTT

#endif
