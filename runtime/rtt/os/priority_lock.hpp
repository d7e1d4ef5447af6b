// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_PRIORITY_LOCK_HPP
#define ORO_OS_PRIORITY_LOCK_HPP

#include <rtt/os/futex.hpp>

#include <atomic>
#include <cstdint>
#include <ctime>
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace RTT {
namespace os {
namespace detail {

/**
 * Holds a lock, which should take microseconds. It makes a system call only if another thread has the lock. The holder
 * inherits the priority of the waiters. Not recursive. The word is 0 at first.
 */
class PriorityLock {
public:
    explicit PriorityLock(std::atomic<std::uint32_t>& word) noexcept : word_(word) {
        std::uint32_t nobody = 0;
        while (!word_.compare_exchange_strong(nobody, self(), std::memory_order_acquire)) {
            if (syscall(SYS_futex, &word_, FUTEX_LOCK_PI | FUTEX_PRIVATE_FLAG, 0, nullptr, nullptr, 0) == 0) {
                (void)word_.load(std::memory_order_acquire);  // pairs with the release below
                return;
            }
            const TIME_SPEC moment{0, 20000};
            nanosleep(&moment, nullptr);  // the holder is ending, or this system has no such futexes
            nobody = 0;
        }
    }
    ~PriorityLock() {
        std::uint32_t mine = self();
        // If that fails, the kernel has marked the word because a thread waits, and hands the lock over.
        if (word_.compare_exchange_strong(mine, 0, std::memory_order_release)) return;
        word_.fetch_or(0, std::memory_order_release);
        syscall(SYS_futex, &word_, FUTEX_UNLOCK_PI | FUTEX_PRIVATE_FLAG, 0, nullptr, nullptr, 0);
    }
    PriorityLock(const PriorityLock&) = delete;
    PriorityLock& operator=(const PriorityLock&) = delete;

private:
    static std::uint32_t self() noexcept { return static_cast<std::uint32_t>(currentTid()); }
    std::atomic<std::uint32_t>& word_;  // in the kernel's format: Linux id of the holder, and flags
};

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
