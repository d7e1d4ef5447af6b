// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_COMPONENT_THREAD_HPP
#define OROFORGE_LIVE_COMPONENT_THREAD_HPP

#include <rtt/internal/engine/engine_gate.hpp>

#include <cstdint>
#include <functional>
#include <string>

namespace OCL::live {

typedef boost::intrusive_ptr<const RTT::internal::EngineGate> Gate;

struct Limit {
    std::int64_t deadline;  ///< monotonic, in ns
    double seconds;         ///< what the client asked for, for messages
};

/**
 * Executes `work` in the thread of a component, between two of its steps, and waits for the end. This thread executes
 * it if no other one executes the component: if its activity is not active, or is a slave or sequential. What `work`
 * throws, this throws. Throws Failure, naming the component `name`, if it is gone, takes no messages, or has not
 * ended the work at the limit; what was not begun by then will not be.
 *
 * The thread of the component allocates nothing for this and wakes the waiting thread with one system call. The caller
 * must not visit the component, and `work` must own what it uses.
 */
void inThreadOf(const Gate& gate, const std::string& name, const Limit& limit, std::function<void()> work);

/** The monotonic time in so many seconds, in ns. */
std::int64_t deadlineIn(double seconds);
/** "1 s", "0.25 s". */
std::string secondsText(double seconds);

}  // namespace OCL::live

#endif
