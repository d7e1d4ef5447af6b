// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_PROCESS_BARRIER_HPP
#define ORO_INTERNAL_DETAIL_PROCESS_BARRIER_HPP

#include <linux/membarrier.h>
#include <sys/syscall.h>
#include <unistd.h>

/**
 * @file The expensive half of an asymmetric barrier. A thread that stores and then loads, thousands of times in a
 * second, only keeps the compiler from reordering the two; the thread that rarely does the opposite has the kernel put
 * a barrier into all running threads of the process.
 */
namespace RTT {
namespace internal {
namespace detail {

/** False if the kernel has no membarrier(2); both threads then need a barrier of their own. */
inline bool offersProcessBarrier() noexcept {
    return syscall(SYS_membarrier, MEMBARRIER_CMD_REGISTER_PRIVATE_EXPEDITED, 0, 0) == 0;
}

/** Makes what other threads did before visible here, and what this thread did before visible to what they do from now
    on. Only if offersProcessBarrier(). A system call of a few microseconds. */
inline void processBarrier() noexcept {
    while (syscall(SYS_membarrier, MEMBARRIER_CMD_PRIVATE_EXPEDITED, 0, 0) != 0)
        syscall(SYS_membarrier, MEMBARRIER_CMD_REGISTER_PRIVATE_EXPEDITED, 0, 0);  // a forked child must ask again
}

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
