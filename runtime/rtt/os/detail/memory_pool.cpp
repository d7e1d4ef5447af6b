// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/memory_pool.hpp>

#include <rtt/os/detail/memory_blocks.hpp>

#include <cstdlib>
#include <cstring>
#include <new>
#include <unistd.h>

namespace RTT::os::detail {

namespace {

class Locked {
public:
    explicit Locked(pthread_mutex_t& mutex) noexcept : mutex_(mutex) { pthread_mutex_lock(&mutex_); }
    ~Locked() { pthread_mutex_unlock(&mutex_); }
    Locked(const Locked&) = delete;
    Locked& operator=(const Locked&) = delete;

private:
    pthread_mutex_t& mutex_;
};

std::size_t roundedUp(std::size_t size) noexcept {
    return (size + MemoryPool::kAlignment - 1) & ~(MemoryPool::kAlignment - 1);
}

/** The block size for a payload of `size` bytes; 0 if that is too large. */
std::size_t blockSize(std::size_t size) noexcept {
    if (size > SizeClass::kLargest) return 0;
    return size == 0 ? SizeClass::kStep : roundedUp(size);
}

// Ends the process, as the heap of libc does: going on would hand out memory twice.
[[noreturn]] void die(const char* what) noexcept {
    const auto ignored = write(STDERR_FILENO, what, std::strlen(what));
    (void)ignored;
    std::abort();
}

/** The part of `memory` that begins and ends at a multiple of the alignment. */
bool align(void*& memory, std::size_t& size) noexcept {
    const auto address = reinterpret_cast<std::uintptr_t>(memory);
    const std::size_t skipped = roundedUp(address) - address;
    if (!memory || size <= skipped) return false;
    memory = static_cast<char*>(memory) + skipped;
    size = (size - skipped) & ~(MemoryPool::kAlignment - 1);
    return true;
}

}  // namespace

MemoryPool::MemoryPool(std::size_t ownSize) noexcept : usage_{ownSize, ownSize, ownSize, ownSize} {
    pthread_mutexattr_t attributes;
    pthread_mutexattr_init(&attributes);
    pthread_mutexattr_setprotocol(&attributes, PTHREAD_PRIO_INHERIT);
    pthread_mutex_init(&mutex_, &attributes);
    pthread_mutexattr_destroy(&attributes);
}

MemoryPool::~MemoryPool() { pthread_mutex_destroy(&mutex_); }

MemoryPool* MemoryPool::create(void* memory, std::size_t size) noexcept {
    constexpr std::size_t own = (sizeof(MemoryPool) + kAlignment - 1) & ~(kAlignment - 1);
    if (!align(memory, size) || size < own) return nullptr;
    auto* pool = new (memory) MemoryPool(own);
    if (pool->addArea(static_cast<char*>(memory) + own, size - own) != 0) return pool;
    pool->~MemoryPool();
    return nullptr;
}

std::size_t MemoryPool::addArea(void* memory, std::size_t size) noexcept {
    if (!align(memory, size)) return 0;
    if (size > SizeClass::kLargest) size = SizeClass::kLargest;
    if (size < Area::kOverhead + Block::kHeader + Block::kMinimum) return 0;
    Area* area = new (memory) Area{nullptr, size};
    Block* block = area->first();
    block->before = nullptr;
    block->word = size - Area::kOverhead - Block::kHeader;
    const std::size_t usable = block->size();
    Block* end = block->after();
    end->before = block;
    end->word = 0;
    Locked lock(mutex_);
    area->next = areas_;
    areas_ = area;
    usage_.total += size;
    usage_.overhead += Area::kOverhead;
    usage_.used += Area::kOverhead;
    if (usage_.maxUsed < usage_.used) usage_.maxUsed = usage_.used;
    join(block);
    return usable;
}

void MemoryPool::insert(Block* block) noexcept {
    const SizeClass at = SizeClass::of(block->size());
    Block*& head = lists_[at.power][at.part];
    block->word |= Block::kFree;
    block->next = head;
    block->previous = nullptr;
    if (head) head->previous = block;
    head = block;
    parts_[at.power] |= 1u << at.part;
    powers_ |= 1u << at.power;
}

void MemoryPool::remove(Block* block) noexcept {
    const SizeClass at = SizeClass::of(block->size());
    block->word &= ~Block::kFree;
    if (block->next) block->next->previous = block->previous;
    if (block->previous) {
        block->previous->next = block->next;
        return;
    }
    lists_[at.power][at.part] = block->next;
    if (block->next) return;
    parts_[at.power] &= ~(1u << at.part);
    if (parts_[at.power] == 0) powers_ &= ~(1u << at.power);
}

/** A free block of at least this size. */
MemoryPool::Block* MemoryPool::find(std::size_t size) const noexcept {
    SizeClass at = SizeClass::atLeast(size);
    std::uint32_t parts = parts_[at.power] & (~0u << at.part);
    if (parts == 0) {
        const std::uint32_t powers = powers_ & (~0u << at.power << 1);
        if (powers == 0) return nullptr;
        at.power = static_cast<unsigned>(__builtin_ctz(powers));
        parts = parts_[at.power];
    }
    return lists_[at.power][static_cast<unsigned>(__builtin_ctz(parts))];
}

/** Joins a block that is in no list with its free neighbours and puts the result into a list. */
void MemoryPool::join(Block* block) noexcept {
    Block* after = block->after();
    if (after->isFree()) {
        remove(after);
        block->word += Block::kHeader + after->size();
    }
    if (block->before && block->before->isFree()) {
        Block* before = block->before;
        remove(before);
        before->word += Block::kHeader + block->size();
        block = before;
    }
    block->after()->before = block;
    insert(block);
}

/** Frees the rest of a used block beyond `size`, if that is enough for a block. */
void MemoryPool::splitOff(Block* block, std::size_t size) noexcept {
    const std::size_t rest = block->size() - size;
    if (rest < Block::kHeader + Block::kMinimum) return;
    block->word = size;
    Block* remainder = block->after();
    remainder->before = block;
    remainder->word = rest - Block::kHeader;
    remainder->after()->before = remainder;
    join(remainder);
}

/** Turns a block that is in no list into a used one of this size. */
void MemoryPool::take(Block* block, std::size_t size) noexcept {
    splitOff(block, size);
    usage_.used += Block::kHeader + block->size();
    if (usage_.maxUsed < usage_.used) usage_.maxUsed = usage_.used;
}

void* MemoryPool::allocate(std::size_t size) noexcept {
    size = blockSize(size);
    if (size == 0) return nullptr;
    Locked lock(mutex_);
    Block* block = find(size);
    if (!block) return nullptr;
    remove(block);
    take(block, size);
    return block->payload();
}

void MemoryPool::release(void* payload) noexcept {
    if (!payload) return;
    Block* block = Block::of(payload);
    Locked lock(mutex_);
    if (reinterpret_cast<std::uintptr_t>(payload) % kAlignment != 0 || block->isFree() || block->isEnd() ||
        block->after()->before != block)
        die("real-time memory: released twice, not allocated here, or written beyond its end\n");
    usage_.used -= Block::kHeader + block->size();
    join(block);
}

bool MemoryPool::resizeInPlace(Block* block, std::size_t size) noexcept {
    Block* after = block->after();
    const std::size_t old = block->size();
    const std::size_t room = old + (after->isFree() ? Block::kHeader + after->size() : 0);
    if (room < size) return false;
    if (old < size) {
        remove(after);
        block->word = room;
        block->after()->before = block;
    }
    usage_.used -= Block::kHeader + old;
    take(block, size);
    return true;
}

void* MemoryPool::resize(void* payload, std::size_t size) noexcept {
    if (!payload) return allocate(size);
    const std::size_t wanted = blockSize(size);
    if (wanted == 0) return nullptr;
    Block* block = Block::of(payload);
    {
        Locked lock(mutex_);
        if (resizeInPlace(block, wanted)) return payload;
    }
    void* copy = allocate(size);
    if (!copy) return nullptr;
    std::memcpy(copy, payload, block->size());  // it is in use, so no other thread changes its size
    release(payload);
    return copy;
}

MemoryPool::Usage MemoryPool::usage() const noexcept {
    Locked lock(mutex_);
    return usage_;
}

}  // namespace RTT::os::detail
