// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The layout of blocks in the areas of a MemoryPool. For its own sources only.
#ifndef RTT_OS_DETAIL_MEMORY_BLOCKS_HPP
#define RTT_OS_DETAIL_MEMORY_BLOCKS_HPP

#include <rtt/os/memory_pool.hpp>

namespace RTT {
namespace os {
namespace detail {

/** Header of a block. The payload of a free block holds its place in a list. */
struct MemoryPool::Block {
    static constexpr std::size_t kHeader = 16;
    static constexpr std::size_t kFree = 1;  // a flag in the size, which is a multiple of 16
    static constexpr std::size_t kMinimum = 16;

    Block* before;  // the block in front of this one in memory; null for the first of an area
    std::size_t word;
    Block* next;  // used, as the next member, only while the block is free
    Block* previous;

    std::size_t size() const noexcept { return word & ~kFree; }
    bool isFree() const noexcept { return (word & kFree) != 0; }
    bool isEnd() const noexcept { return word == 0; }
    void* payload() noexcept { return reinterpret_cast<char*>(this) + kHeader; }
    Block* after() noexcept { return reinterpret_cast<Block*>(reinterpret_cast<char*>(this) + kHeader + size()); }
    static Block* of(void* payload) noexcept { return reinterpret_cast<Block*>(static_cast<char*>(payload) - kHeader); }
};

/** Start of an area; its first block follows, its end marker (a used block of size 0) is at the end. */
struct MemoryPool::Area {
    static constexpr std::size_t kOverhead = 2 * Block::kHeader;  // this header and the end marker

    Area* next;
    std::size_t size;
    Block* first() noexcept { return reinterpret_cast<Block*>(reinterpret_cast<char*>(this) + Block::kHeader); }
};

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
