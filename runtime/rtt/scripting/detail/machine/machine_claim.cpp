// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/machine/machine_claim.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/os/fosi.h>

#include <unistd.h>

namespace RTT::scripting::detail {

namespace {
// Between two attempts: a component's thread, in ns, and others, in µs.
constexpr std::int64_t kSlice = 1000000;
constexpr useconds_t kSleep = 100;
constexpr unsigned kTries = 1000;  // some microseconds
}  // namespace

// The thread that holds the machine may be waiting for an operation that only this thread can execute.
void MachineClaim::wait(std::int64_t patience) {
    for (unsigned tries = kTries; tries != 0; --tries)
        if (take()) return;
    if (patience < 0) return;
    const std::int64_t end = rtos_get_time_ns() + patience;
    const internal::EngineGate* const own = internal::EngineGate::ofThisThread();
    ExecutionEngine* const engine = own ? own->engine() : nullptr;
    while (!take() && rtos_get_time_ns() < end) {
        if (engine)
            engine->waitForMessages([this] { return owner_.load(std::memory_order_relaxed) == 0; },
                                    rtos_get_time_ns() + kSlice);
        else
            usleep(kSleep);
    }
}

}  // namespace RTT::scripting::detail
