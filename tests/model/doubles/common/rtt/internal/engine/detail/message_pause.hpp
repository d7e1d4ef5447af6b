// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: a pause in which there are no messages.
#ifndef OROFORGE_MODEL_MESSAGE_PAUSE_HPP
#define OROFORGE_MODEL_MESSAGE_PAUSE_HPP

#include <rtt/os/futex.hpp>

namespace RTT {
namespace internal {
namespace detail {

inline void pauseForMessages(const std::atomic<std::uint32_t>& word, std::uint32_t seen) {
    os::detail::futexWait(word, seen, os::detail::kForever);
}

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
