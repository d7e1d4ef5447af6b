// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_MESSAGE_PAUSE_HPP
#define ORO_INTERNAL_DETAIL_MESSAGE_PAUSE_HPP

#include <rtt/internal/engine/engine_gate.hpp>

namespace RTT {
namespace internal {
namespace detail {

/** EngineGate::sleepOn(), which model tests replace. */
inline void pauseForMessages(const Presence::Word& word, std::uint32_t seen) { EngineGate::sleepOn(word, seen); }

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
