// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The invariants of a MemoryPool, checked from its memory alone.
#include <rtt/os/detail/memory_blocks.hpp>
#include <rtt/os/memory_pool.hpp>

namespace RTT::os::detail {

std::string MemoryPool::findFaultInBlocks(std::size_t& used, std::size_t& freeBlocks) const {
    for (Area* area = areas_; area; area = area->next) {
        char* const end = reinterpret_cast<char*>(area) + area->size - Block::kHeader;
        Block* before = nullptr;
        for (Block* block = area->first();; block = block->after()) {
            if (reinterpret_cast<char*>(block) > end) return "a block reaches beyond the end of its area";
            if (block->before != before) return "a block does not know the block before it";
            if (block->isEnd()) {
                if (reinterpret_cast<char*>(block) != end) return "an area ends before its end";
                break;
            }
            if (block->size() % kAlignment != 0 || block->size() < Block::kMinimum) return "a block has no valid size";
            if (block->isFree()) {
                if (before && before->isFree()) return "two free blocks are neighbours";
                ++freeBlocks;
            } else {
                used += Block::kHeader + block->size();
            }
            before = block;
        }
    }
    return {};
}

std::string MemoryPool::findFaultInLists(std::size_t freeBlocks) const {
    std::size_t listed = 0;
    for (unsigned power = 0; power != SizeClass::kPowers; ++power) {
        if (((powers_ >> power) & 1u) != (parts_[power] != 0)) return "the upper bit map disagrees with the lower";
        for (unsigned part = 0; part != SizeClass::kParts; ++part) {
            Block* const head = lists_[power][part];
            if (((parts_[power] >> part) & 1u) != (head != nullptr)) return "a bit map disagrees with a list";
            Block* previous = nullptr;
            for (Block* block = head; block; block = block->next) {
                const SizeClass at = SizeClass::of(block->size());
                if (!block->isFree()) return "a used block is in a list";
                if (at.power != power || at.part != part) return "a block is in the list of another size";
                if (block->previous != previous) return "a list is not linked backwards";
                if (++listed > freeBlocks) return "there are more blocks in lists than free ones";
                previous = block;
            }
        }
    }
    return listed == freeBlocks ? std::string() : "a free block is in no list";
}

std::string MemoryPool::findFault() const {
    pthread_mutex_lock(&mutex_);
    std::size_t used = usage_.overhead, freeBlocks = 0;
    std::string fault = findFaultInBlocks(used, freeBlocks);
    if (fault.empty()) fault = findFaultInLists(freeBlocks);
    if (fault.empty() && used != usage_.used) fault = "the blocks in use do not add up to the count";
    if (fault.empty() && usage_.maxUsed < usage_.used) fault = "more is in use than ever was";
    pthread_mutex_unlock(&mutex_);
    return fault;
}

}  // namespace RTT::os::detail
