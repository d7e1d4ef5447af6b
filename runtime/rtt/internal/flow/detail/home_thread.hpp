// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Most stores have one writer. It gets slots of its own and needs no atomic read-modify-write to claim one.
#ifndef ORO_INTERNAL_DETAIL_HOME_THREAD_HPP
#define ORO_INTERNAL_DETAIL_HOME_THREAD_HPP

#include <rtt/internal/engine/detail/this_thread.hpp>

#include <atomic>

namespace RTT {
namespace internal {
namespace detail {

/** The thread that owns a store's private slots. Once chosen it stays: a thread that ended, or no longer writes, leaves
    its slots unused, and others write as they would with many writers. Data of the home thread may be plain variables:
    only it gets past here(), or a later thread with the same identity, which is ordered after it. */
class HomeThread {
public:
    bool here() const noexcept { return thread_.load(std::memory_order_relaxed) == thisThread(); }

    /** For another thread after it has written. One that writes often enough in a row becomes the home thread; a
        deployer that writes initial values does not. */
    void wrote() noexcept {
        if (thread_.load(std::memory_order_relaxed)) return;
        const void* const me = thisThread();
        if (last_.load(std::memory_order_relaxed) != me) {
            last_.store(me, std::memory_order_relaxed);
            inARow_.store(0, std::memory_order_relaxed);
            return;
        }
        const unsigned n = inARow_.load(std::memory_order_relaxed) + 1;
        inARow_.store(n, std::memory_order_relaxed);
        const void* none = nullptr;
        if (n == kInARow) thread_.compare_exchange_strong(none, me, std::memory_order_relaxed);
    }

private:
    static constexpr unsigned kInARow = 8;
    std::atomic<const void*> thread_{nullptr};
    std::atomic<const void*> last_{nullptr};
    std::atomic<unsigned> inARow_{0};
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
