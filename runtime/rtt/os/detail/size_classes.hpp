// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_OS_DETAIL_SIZE_CLASSES_HPP
#define RTT_OS_DETAIL_SIZE_CLASSES_HPP

#include <cstddef>

namespace RTT {
namespace os {
namespace detail {

/**
 * Sorts sizes (multiples of 16 bytes) into lists of free blocks, on two levels: a power of two, divided into 32 equal
 * parts. The parts of level 0 are the multiples of 16 below 512. At most 1/32 of a size is wasted.
 */
struct SizeClass {
    unsigned power;  // first level
    unsigned part;   // second level

    static constexpr std::size_t kStep = 16;
    static constexpr unsigned kPartBits = 5;
    static constexpr unsigned kParts = 1u << kPartBits;
    static constexpr std::size_t kLinear = kStep * kParts;  // sizes below are on level 0
    static constexpr unsigned kPowers = 28;
    /** Larger blocks do not exist: they would need another level. */
    static constexpr std::size_t kLargest = (std::size_t(1) << 35) - kStep;

    /** The list in which a free block of this size is kept. */
    static SizeClass of(std::size_t size) noexcept {
        if (size < kLinear) return {0, static_cast<unsigned>(size / kStep)};
        const unsigned log = 63u - static_cast<unsigned>(__builtin_clzll(size));
        return {log - 8u, static_cast<unsigned>(size >> (log - kPartBits)) - kParts};
    }

    /**
     * The first list in which every block is at least this large. A search takes its first block and never looks at a
     * second one, so it takes constant time.
     */
    static SizeClass atLeast(std::size_t size) noexcept {
        if (size < kLinear) return of(size);
        const unsigned log = 63u - static_cast<unsigned>(__builtin_clzll(size));
        return of(size + (std::size_t(1) << (log - kPartBits)) - 1);
    }
};

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
