// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: the checker's futex. Deadlines never come, except 0, which is in the past.
#ifndef OROFORGE_MODEL_FUTEX_HPP
#define OROFORGE_MODEL_FUTEX_HPP

#include <rtt/os/fosi.h>

namespace RTT {
namespace os {
namespace detail {

constexpr NANO_TIME kForever = LLONG_MAX;
constexpr NANO_TIME after(NANO_TIME now, NANO_TIME wait) noexcept {
    return wait > kForever - now ? kForever : now + wait;
}

inline bool futexWait(const std::atomic<std::uint32_t>& word, std::uint32_t expected, NANO_TIME deadline) noexcept {
    return deadline > 0 && model::futexWait(word, expected);
}
struct FutexWord {
    const std::atomic<std::uint32_t>* word;
    std::uint32_t expected;
};
constexpr unsigned kMostFutexWords = 8;
/** Looks again after each change by another thread: that a change is seen is checked here, that it wakes by futexWait(). */
inline bool futexWaitAny(const FutexWord*, unsigned, NANO_TIME) noexcept {
    model::yield();
    return true;
}
inline void futexWakeOne(const std::atomic<std::uint32_t>& word) noexcept { model::futexWake(word, 1); }
inline void futexWakeAll(const std::atomic<std::uint32_t>& word) noexcept { model::futexWake(word, ~0u); }
inline pid_t currentTid() noexcept { return static_cast<pid_t>(model::self()) + 1; }
inline bool threadExists(pid_t) noexcept { return true; }

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
