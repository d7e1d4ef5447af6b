// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_OS_DETAIL_WAKE_WORD_HPP
#define RTT_OS_DETAIL_WAKE_WORD_HPP

#include <rtt/os/futex.hpp>

namespace RTT {
namespace os {
namespace detail {

/**
 * One word with the reasons why a thread must wake up and the flag that it sleeps. Any thread posts, one thread waits.
 *
 * The word goes 0 → kSleeping → kSleeping|reasons → 0 when the thread had to sleep, or
 *                0 → reasons → 0                        when it was awake.
 *
 * No wake-up is lost: every change of the word is an atomic read-modify-write, so all of them are in one order. A post
 * comes before the owner's exchange in wait(), which returns its reasons, or after it; then it is found by the next
 * wait(), whose compare-exchange from 0 fails. A post between that compare-exchange and the system call changes the
 * word, and FUTEX_WAIT returns at once because it no longer holds kSleeping.
 *
 * At most one system call per sleep: only the post that finds exactly kSleeping wakes. The thread cannot sleep again
 * before it has taken the reasons, so later posts know that it has been or is being woken.
 *
 * A post must not be left out because the reason seems to be set already: the owner may have taken that reason before
 * it could see what the poster wrote.
 */
class WakeWord {
public:
    /**
     * Adds reasons (never kSleeping) and wakes the thread if it sleeps. Real-time safe.
     *
     * Release: what the poster wrote before is visible to the thread once wait() has returned the reason. Several
     * posters: each read-modify-write continues the release sequence of the earlier ones, so the one exchange of
     * the owner synchronises with all of them. No acquire: a poster reads nothing that the owner writes.
     */
    void post(std::uint32_t reasons) noexcept {
        if (word_.fetch_or(reasons, std::memory_order_release) == kSleeping) futexWakeOne(word_);
    }

    /** Sleeps until there is a reason or the monotonic time has come; takes and returns the reasons, 0 for the
        latter. */
    std::uint32_t wait(NANO_TIME deadline) noexcept {
        std::uint32_t nothing = 0;
        // Relaxed: success publishes nothing, failure is followed by the acquiring exchange.
        if (word_.compare_exchange_strong(nothing, kSleeping, std::memory_order_relaxed)) {
            while (word_.load(std::memory_order_relaxed) == kSleeping && futexWait(word_, kSleeping, deadline)) {
            }
        }
        // Acquire: pairs with the release in post().
        return word_.exchange(0, std::memory_order_acquire) & ~kSleeping;
    }

private:
    static constexpr std::uint32_t kSleeping = 0x80000000u;
    std::atomic<std::uint32_t> word_{0};
};

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
