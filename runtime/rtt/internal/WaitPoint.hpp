// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_WAIT_POINT_HPP
#define ORO_INTERNAL_WAIT_POINT_HPP

#include <rtt/rtt-config.h>

#include <atomic>
#include <cstdint>

namespace RTT {
namespace internal {

/**
 * Where threads wait for something an engine is told. Shared by reference count, because whoever announces the end of
 * an operation may do so after the waiting component has seen it and is gone.
 *
 * A waiter: `auto ticket = prepare(); if (condition) cancel(); else wait(ticket);` A notifier changes the condition
 * and then calls notify(). All operations on both words are sequentially consistent, so either the notifier sees the
 * waiter or the waiter's condition is already true.
 */
class RTT_API WaitPoint {
public:
    std::uint32_t prepare() {
        waiters_.fetch_add(1);
        return epoch_.load();
    }
    void cancel() { waiters_.fetch_sub(1); }
    /** Sleeps until a notify() after prepare(). Blocks. */
    void wait(std::uint32_t ticket);
    /** Wakes all waiters. Real-time safe; a system call only if somebody waits. */
    void notify() {
        epoch_.fetch_add(1);
        if (waiters_.load() != 0) wake();
    }

private:
    void wake();

    std::atomic<std::uint32_t> epoch_{0};
    std::atomic<std::uint32_t> waiters_{0};
};

}  // namespace internal
}  // namespace RTT

#endif
