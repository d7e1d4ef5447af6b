// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/calls/call_pool.hpp>

#include <atomic>
#include <cstdint>
#include <new>

namespace RTT::internal {

namespace {

/**
 * A stack of free blocks. Blocks have numbers, 1 to Count. The links are kept beside the blocks, so a thread that is
 * late reads an outdated link from an atomic, and not from a block in use. The head carries a tag that grows with every
 * change: an exchange fails if the same block was taken and given back since it began. Blocks that were never used are
 * not on the stack. They are handed out in order, so nothing has to be set up before main().
 */
template <std::size_t BlockSize, std::uint32_t Count>
class FreeBlocks {
public:
    void* take() {
        std::uint64_t head = head_.load(std::memory_order_acquire);
        while (const std::uint32_t number = static_cast<std::uint32_t>(head)) {
            const std::uint64_t next = changed(head, next_[number - 1].load(std::memory_order_relaxed));
            // Acquire: pairs with give(), so the previous user has finished with the block.
            if (head_.compare_exchange_weak(head, next, std::memory_order_acquire)) return blocks_[number - 1].bytes;
        }
        std::uint32_t fresh = fresh_.load(std::memory_order_relaxed);
        while (fresh != Count)
            if (fresh_.compare_exchange_weak(fresh, fresh + 1, std::memory_order_relaxed)) return blocks_[fresh].bytes;
        return nullptr;
    }
    void give(void* block) {
        const std::uint32_t number = static_cast<std::uint32_t>(static_cast<Block*>(block) - blocks_) + 1;
        std::uint64_t head = head_.load(std::memory_order_relaxed);
        std::uint64_t next;
        do {
            next_[number - 1].store(static_cast<std::uint32_t>(head), std::memory_order_relaxed);
            next = changed(head, number);
            // Release: the link, and everything done with the block, happens before the next take().
        } while (!head_.compare_exchange_weak(head, next, std::memory_order_release));
    }
    bool owns(const void* block) const {
        const auto at = reinterpret_cast<std::uintptr_t>(block), begin = reinterpret_cast<std::uintptr_t>(blocks_);
        return at >= begin && at < begin + sizeof(blocks_);
    }

private:
    static std::uint64_t changed(std::uint64_t head, std::uint32_t number) {
        return (((head >> 32) + 1) << 32) | number;
    }
    struct Block {
        alignas(std::max_align_t) unsigned char bytes[BlockSize];
    };
    std::atomic<std::uint64_t> head_{0};
    std::atomic<std::uint32_t> fresh_{0};
    std::atomic<std::uint32_t> next_[Count] = {};
    Block blocks_[Count];
};

// Constant-initialised and never destroyed: calls may outlive main().
FreeBlocks<256, CallPool::kSmall> smallBlocks;
FreeBlocks<1024, CallPool::kLarge> largeBlocks;

}  // namespace

void* CallPool::take(std::size_t size) {
    void* block = nullptr;
    if (size <= 256) block = smallBlocks.take();
    if (!block && size <= 1024) block = largeBlocks.take();
    return block ? block : ::operator new(size);
}

void CallPool::give(void* block) noexcept {
    if (smallBlocks.owns(block))
        smallBlocks.give(block);
    else if (largeBlocks.owns(block))
        largeBlocks.give(block);
    else
        ::operator delete(block);
}

bool CallPool::owns(const void* block) noexcept { return smallBlocks.owns(block) || largeBlocks.owns(block); }

}  // namespace RTT::internal
