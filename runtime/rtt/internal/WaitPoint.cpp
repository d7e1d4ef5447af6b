// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/WaitPoint.hpp>

#include <rtt/os/detail/futex.hpp>

namespace RTT::internal {

void WaitPoint::wait(std::uint32_t ticket, std::int64_t deadline) {
    std::uint32_t asleep = 0;
    do {
        if (!arm(ticket, asleep) || !os::detail::futexWait(word_, asleep, deadline)) return;
    } while (this->ticket() == ticket);
}

// Who is woken by something else leaves the bit behind: the next notify() makes a system call for nobody.
bool WaitPoint::arm(std::uint32_t ticket, std::uint32_t& asleep) {
    asleep = ticket | kAsleep;
    std::uint32_t found = ticket;
    // Another waiter may have set the bit already; a notifier may have cleared it for a sleeper that came before us.
    return word_.compare_exchange_strong(found, asleep) || found == asleep;
}

void WaitPoint::wake() {
    // Others may have found the bit as well; the one that clears it wakes. If that bit was set by a later sleeper, the
    // earlier ones were woken when theirs was cleared, and the later one looks again and sleeps on.
    if (word_.fetch_and(~kAsleep) & kAsleep) os::detail::futexWakeAll(word_);
}

}  // namespace RTT::internal
