// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_MESSAGE_PAUSE_HPP
#define ORO_INTERNAL_DETAIL_MESSAGE_PAUSE_HPP

#include <rtt/ExecutionEngine.hpp>
#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/os/futex.hpp>

namespace RTT {
namespace internal {
namespace detail {

/** Sleeps while the futex `word` holds `seen`, and executes the messages of the components that this thread is
    executing. May return early. */
inline void pauseForMessages(const Presence::Word& word, std::uint32_t seen) {
    const EngineGate* const gate = EngineGate::ofThisThread();
    if (gate && gate->engine())
        gate->engine()->waitForMessages([&] { return word != seen; }, os::detail::kForever, &word);
    else
        os::detail::futexWait(word, seen, os::detail::kForever);
}

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
