// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/WaitPoint.hpp>

#include <rtt/os/detail/futex.hpp>

namespace RTT {
namespace internal {

void WaitPoint::wait(std::uint32_t ticket, std::int64_t deadline) {
    const std::uint32_t asleep = ticket | kAsleep;
    do {
        std::uint32_t found = ticket;
        // Another waiter may have set the bit already; a notifier may have cleared it for a sleeper that came before us.
        if (!word_.compare_exchange_strong(found, asleep) && found != asleep) return;
        if (!os::detail::futexWait(word_, asleep, deadline)) return;
    } while (this->ticket() == ticket);
}

void WaitPoint::wake() {
    // Others may have found the bit as well; the one that clears it wakes. If that bit was set by a later sleeper, the
    // earlier ones were woken when theirs was cleared, and the later one looks again and sleeps on.
    if (word_.fetch_and(~kAsleep) & kAsleep) os::detail::futexWakeAll(word_);
}

}  // namespace internal
}  // namespace RTT
