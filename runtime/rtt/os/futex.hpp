// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_FUTEX_HPP
#define ORO_OS_FUTEX_HPP

#include <rtt/os/fosi.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

/**
 * @file The futex system call on an atomic word. The kernel compares the word; its atomic operations order memory.
 */
namespace RTT {
namespace os {
namespace detail {

constexpr NANO_TIME kForever = LLONG_MAX;

/** The moment `wait` nanoseconds (≥ 0) after `now`; "never" if that overflows. */
constexpr NANO_TIME after(NANO_TIME now, NANO_TIME wait) noexcept {
    return wait > kForever - now ? kForever : now + wait;
}

/**
 * Sleeps while `word` holds `expected`, at most until the monotonic time `deadline` (ns). Returns false if that time
 * has come. May also return true without a wake-up: test the word again.
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

/** A word to sleep on, and its value while there is no reason to wake up. */
struct FutexWord {
    const std::atomic<std::uint32_t>* word;
    std::uint32_t expected;
};
constexpr unsigned kMostFutexWords = 8;

/**
 * futexWait() for up to kMostFutexWords words at once: sleeps while each has its expected value. Where the system
 * cannot do that (Linux before 5.16), sleeps on the first one, at most a millisecond, because callers test all words
 * again.
 */
inline bool futexWaitAny(const FutexWord* words, unsigned count, NANO_TIME deadline) noexcept {
#ifdef SYS_futex_waitv
    struct futex_waitv all[kMostFutexWords] = {};
    for (unsigned i = 0; i != count; ++i) {
        all[i].val = words[i].expected;
        all[i].uaddr = reinterpret_cast<std::uintptr_t>(words[i].word);
        all[i].flags = FUTEX_32 | FUTEX_PRIVATE_FLAG;
    }
    TIME_SPEC until;
    TIME_SPEC* untilOrForever = nullptr;
    if (deadline != kForever) {
        until = ticks2timespec(deadline > 0 ? deadline : 0);
        untilOrForever = &until;
    }
    if (syscall(SYS_futex_waitv, all, count, 0, untilOrForever, CLOCK_MONOTONIC) != -1) return true;
    if (errno == ETIMEDOUT) return false;
    if (errno != ENOSYS && errno != EPERM) return true;
#else
    (void)count;
#endif
    const NANO_TIME soon = rtos_get_time_ns() + 1000000;
    return futexWait(*words[0].word, words[0].expected, soon < deadline ? soon : deadline) || soon < deadline;
}

inline void futexWakeOne(const std::atomic<std::uint32_t>& word) noexcept {
    syscall(SYS_futex, &word, FUTEX_WAKE | FUTEX_PRIVATE_FLAG, 1);
}

inline void futexWakeAll(const std::atomic<std::uint32_t>& word) noexcept {
    syscall(SYS_futex, &word, FUTEX_WAKE | FUTEX_PRIVATE_FLAG, INT_MAX);
}

/** The Linux id of the calling thread; one system call per thread. */
inline pid_t currentTid() noexcept {
    static __thread pid_t tid __attribute__((tls_model("initial-exec")));
    if (__builtin_expect(tid == 0, 0)) tid = static_cast<pid_t>(syscall(SYS_gettid));
    return tid;
}

/** False if the thread of this process with this Linux id has ended; another one may have the id by now. A system
    call. */
inline bool threadExists(pid_t tid) noexcept { return syscall(SYS_tgkill, getpid(), tid, 0) == 0 || errno != ESRCH; }

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
