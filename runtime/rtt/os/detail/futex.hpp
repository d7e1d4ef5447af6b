// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_OS_DETAIL_FUTEX_HPP
#define RTT_OS_DETAIL_FUTEX_HPP

#include <rtt/os/fosi.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

/** @file The futex system call on an atomic word. The kernel looks at the word; all ordering comes from the word itself. */
namespace RTT {
namespace os {
namespace detail {

constexpr NANO_TIME kForever = LLONG_MAX;

/**
 * Sleeps while `word` holds `expected`, at most until the monotonic time `deadline` (ns). Returns false if that time has
 * come. May also return true without a wake-up: test the word again.
 */
inline bool futexWait(const std::atomic<std::uint32_t>& word, std::uint32_t expected, NANO_TIME deadline) noexcept {
    TIME_SPEC until;
    TIME_SPEC* untilOrForever = nullptr;
    if (deadline != kForever) {
        until = ticks2timespec(deadline > 0 ? deadline : 0);
        untilOrForever = &until;
    }
    // WAIT_BITSET takes an absolute time on CLOCK_MONOTONIC; plain WAIT would take a duration.
    const long result = syscall(SYS_futex, &word, FUTEX_WAIT_BITSET | FUTEX_PRIVATE_FLAG, expected, untilOrForever,
                                nullptr, FUTEX_BITSET_MATCH_ANY);
    return !(result == -1 && errno == ETIMEDOUT);
}

inline void futexWakeOne(const std::atomic<std::uint32_t>& word) noexcept {
    syscall(SYS_futex, &word, FUTEX_WAKE | FUTEX_PRIVATE_FLAG, 1);
}

inline void futexWakeAll(const std::atomic<std::uint32_t>& word) noexcept {
    syscall(SYS_futex, &word, FUTEX_WAKE | FUTEX_PRIVATE_FLAG, INT_MAX);
}

/** Linux id of the calling thread, asked from the kernel once per thread. */
inline pid_t currentTid() noexcept {
    static thread_local const pid_t tid = static_cast<pid_t>(syscall(SYS_gettid));
    return tid;
}

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
