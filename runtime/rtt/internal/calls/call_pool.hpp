// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Memory for calls in progress, so that sending an operation does not allocate.
#ifndef ORO_INTERNAL_CALL_POOL_HPP
#define ORO_INTERNAL_CALL_POOL_HPP

#include <rtt/rtt-config.h>

#include <cstddef>

namespace RTT {
namespace internal {

/**
 * Blocks of two sizes: kSmall of them up to 256 bytes, kLarge up to 1 KiB, for the whole process. Larger blocks, and
 * blocks beyond those numbers, come from the heap. Lock-free and real-time safe unless the heap is used.
 */
class RTT_API CallPool {
public:
    static constexpr std::size_t kSmall = 256;
    static constexpr std::size_t kLarge = 64;
    static void* take(std::size_t size);
    static void give(void* block) noexcept;
    /** True if `block` belongs to the pool, not to the heap. */
    static bool owns(const void* block) noexcept;
};

}  // namespace internal
}  // namespace RTT

#endif
