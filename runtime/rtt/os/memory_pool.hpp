// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_OS_MEMORY_POOL_HPP
#define RTT_OS_MEMORY_POOL_HPP

#include <rtt/os/detail/size_classes.hpp>
#include <rtt/rtt-config.h>

#include <cstdint>
#include <pthread.h>
#include <string>

namespace RTT {
namespace os {
namespace detail {

/**
 * Memory in which blocks are found, split and joined in a constant number of steps: two-level segregated fit (Masmano,
 * Ripoll, Crespo and Real, "TLSF: a new dynamic memory allocator for real-time systems", ECRTS 2004).
 *
 *   area    [ header | payload ][ header | payload ] … [ end marker ]
 *   lists   free blocks by size class, and two bit maps of the lists that are not empty
 *
 * Two free blocks are never neighbours, because freeing joins them. The object itself is at the start of the memory
 * that it manages, and it makes no system call for memory.
 *
 * Any thread may use it. Functions hold a mutex that inherits priority for a bounded number of instructions: a thread
 * of high priority waits at most for one such section of each thread that came before it.
 */
class RTT_API MemoryPool {
public:
    static constexpr std::size_t kAlignment = SizeClass::kStep;

    /** Makes a pool of this memory, aligned or not; null if it is too small for the pool and one block. */
    static MemoryPool* create(void* memory, std::size_t size) noexcept;
    ~MemoryPool();
    MemoryPool(const MemoryPool&) = delete;
    MemoryPool& operator=(const MemoryPool&) = delete;

    /** Adds memory at any address. Returns how many bytes of it can be allocated; 0 if it is too small. */
    std::size_t addArea(void* memory, std::size_t size) noexcept;

    /** Allocates at least `size` bytes, aligned to 16; null if no block is large enough. Zero bytes count as one. */
    void* allocate(std::size_t size) noexcept;
    /** Null does nothing. Memory that was not allocated here, or is free already, ends the process. */
    void release(void* payload) noexcept;
    /**
     * Changes the size of an allocated block, in place if possible. Otherwise copies it, without holding the mutex. If
     * there is no room, returns null and leaves the block as it is.
     */
    void* resize(void* payload, std::size_t size) noexcept;

    /** Bytes of all areas; overhead of an empty pool; in use, with that overhead; the most that was ever in use. */
    struct Usage {
        std::size_t total, overhead, used, maxUsed;
    };
    Usage usage() const noexcept;

    /** For tests: checks all blocks and lists, and returns what is wrong, or nothing. Holds the mutex all the time. */
    std::string findFault() const;

private:
    struct Block;
    struct Area;
    explicit MemoryPool(std::size_t ownSize) noexcept;

    void insert(Block* block) noexcept;
    void remove(Block* block) noexcept;
    Block* find(std::size_t size) const noexcept;
    void take(Block* block, std::size_t size) noexcept;
    void splitOff(Block* block, std::size_t size) noexcept;
    void join(Block* block) noexcept;
    bool resizeInPlace(Block* block, std::size_t size) noexcept;
    std::string findFaultInBlocks(std::size_t& used, std::size_t& freeBlocks) const;
    std::string findFaultInLists(std::size_t freeBlocks) const;

    mutable pthread_mutex_t mutex_;
    Area* areas_ = nullptr;
    Usage usage_;
    std::uint32_t powers_ = 0;  // bit n: parts_[n] is not 0
    std::uint32_t parts_[SizeClass::kPowers] = {};
    Block* lists_[SizeClass::kPowers][SizeClass::kParts] = {};
};

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
