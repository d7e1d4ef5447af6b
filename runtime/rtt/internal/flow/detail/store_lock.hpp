// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The locks of LOCKED and UNSYNC storages.
#ifndef ORO_INTERNAL_DETAIL_STORE_LOCK_HPP
#define ORO_INTERNAL_DETAIL_STORE_LOCK_HPP

#include <rtt/os/futex.hpp>

#include <atomic>
#include <cstdint>

namespace RTT {
namespace internal {
namespace detail {

struct NoMutex {
    void lock() {}
    void unlock() {}
};

/**
 * A mutex that its holder must not lock again. Inherits priority: the kernel has a holder of low priority run at the
 * priority of the highest waiter. Half the time of os::Mutex while nobody waits, and without a call.
 *
 * The word holds the id of the holder's thread; the kernel marks it while threads wait, see futex(2).
 */
class StoreMutex {
public:
    StoreMutex() = default;
    StoreMutex(const StoreMutex&) = delete;
    StoreMutex& operator=(const StoreMutex&) = delete;

    void lock() noexcept {
        std::uint32_t holder = 0;
        if (!word_.compare_exchange_strong(holder, self(), std::memory_order_acquire, std::memory_order_relaxed))
            os::detail::futexLockPi(word_);
    }
    void unlock() noexcept {
        std::uint32_t holder = self();
        if (!word_.compare_exchange_strong(holder, 0, std::memory_order_release, std::memory_order_relaxed))
            os::detail::futexUnlockPi(word_);
    }

private:
    static std::uint32_t self() noexcept { return static_cast<std::uint32_t>(os::detail::currentTid()); }
    std::atomic<std::uint32_t> word_{0};
};

/** Holds a lock for a scope. */
template <class Mutex>
class Hold {
public:
    explicit Hold(Mutex& mutex) : mutex_(mutex) { mutex_.lock(); }
    ~Hold() { mutex_.unlock(); }
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

private:
    Mutex& mutex_;
};
template <>
class Hold<NoMutex> {
public:
    explicit Hold(NoMutex&) {}
    ~Hold() {}
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
