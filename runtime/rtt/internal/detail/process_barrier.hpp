// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_PROCESS_BARRIER_HPP
#define ORO_INTERNAL_DETAIL_PROCESS_BARRIER_HPP

#include <linux/membarrier.h>
#include <sys/syscall.h>
#include <unistd.h>

/**
 * @file The expensive half of an asymmetric barrier. A thread that makes a store and then a load, thousands of times in a
 * second, only keeps the compiler from exchanging them; the thread that seldom makes the opposite has the kernel put a
 * barrier into all running threads of the process.
 */
namespace RTT {
namespace internal {
namespace detail {

/** False if the kernel has no membarrier(2): then both threads need a barrier of their own. */
inline bool offersProcessBarrier() noexcept {
    return syscall(SYS_membarrier, MEMBARRIER_CMD_REGISTER_PRIVATE_EXPEDITED, 0, 0) == 0;
}

/** What the other threads did before is visible here, and what this thread did before, to all that they do from now on.
    For a process to which it was offered. A system call of a few microseconds. */
inline void processBarrier() noexcept {
    while (syscall(SYS_membarrier, MEMBARRIER_CMD_PRIVATE_EXPEDITED, 0, 0) != 0)
        syscall(SYS_membarrier, MEMBARRIER_CMD_REGISTER_PRIVATE_EXPEDITED, 0, 0);  // a forked child must ask again
}

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
