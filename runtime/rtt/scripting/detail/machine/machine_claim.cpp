// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/machine/machine_claim.hpp>

#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/os/fosi.h>

namespace RTT::scripting::detail {

namespace {
constexpr unsigned kTries = 1000;  // some microseconds
}  // namespace

// The thread that holds the machine may be waiting for an operation that only this thread can execute.
void MachineClaim::wait(std::int64_t patience) {
    for (unsigned tries = kTries; tries != 0; --tries)
        if (take()) return;
    if (patience < 0) return;
    const std::int64_t end = rtos_get_time_ns() + patience;
    while (!take() && rtos_get_time_ns() < end) {
        std::uint32_t seen = owner_.load(std::memory_order_relaxed);
        if (seen == 0) continue;
        if ((seen & kAwaited) || owner_.compare_exchange_strong(seen, seen | kAwaited, std::memory_order_relaxed))
            internal::EngineGate::sleepOn(owner_, seen | kAwaited, end);
    }
}

}  // namespace RTT::scripting::detail
