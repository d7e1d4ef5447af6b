// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/wait_point.hpp>

#include <rtt/os/futex.hpp>

namespace RTT::internal {

void WaitPoint::wait(std::uint32_t ticket, std::int64_t deadline) {
    std::uint32_t asleep = 0;
    do {
        if (!arm(ticket, asleep) || !os::detail::futexWait(word_, asleep, deadline)) return;
    } while (this->ticket() == ticket);
}

// A waiter that something else wakes leaves the bit behind: the next notify() then makes a useless system call.
bool WaitPoint::arm(std::uint32_t ticket, std::uint32_t& asleep) {
    asleep = ticket | kAsleep;
    std::uint32_t found = ticket;
    // Another waiter may have set the bit already; a notifier may have cleared it for a sleeper that came before us.
    return word_.compare_exchange_strong(found, asleep) || found == asleep;
}

void WaitPoint::wake() {
    // Several notifiers may find the bit; the one that clears it wakes. If a later sleeper set that bit, the earlier
    // ones were woken when theirs was cleared, and the later one looks again and continues to sleep.
    if (word_.fetch_and(~kAsleep) & kAsleep) os::detail::futexWakeAll(word_);
}

}  // namespace RTT::internal
