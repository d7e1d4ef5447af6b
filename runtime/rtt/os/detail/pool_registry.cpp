// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/detail/pool_registry.hpp>

#include <cstdlib>
#include <cstring>
#include <sys/mman.h>
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

}  // namespace

PoolRegistry& PoolRegistry::instance() noexcept {
    // No destructor runs: all members are trivially destructible.
    static PoolRegistry registry;
    return registry;
}

// Memory orders. An entry is written, then published by count_ (release) or, if it is reused, by its pool (release); a
// pool is published by current_ (release). Readers acquire, so a thread that finds a pool sees it complete. A thread
// that frees a block got it from the thread that allocated it, which had found the pool: the entry happened before, and
// no stale count_ can hide it.

MemoryPool* PoolRegistry::current() noexcept {
    MemoryPool* const pool = current_.load(std::memory_order_acquire);
    return pool ? pool : makeDefault();
}

MemoryPool* PoolRegistry::makeDefault() noexcept {
    Locked lock(changes_);
    if (MemoryPool* made = current_.load(std::memory_order_relaxed)) return made;
    if (!default_ && hasRoom(nullptr)) {
        // Populated, because otherwise the first use of a page would be a page fault in a real-time thread.
        void* memory =
            mmap(nullptr, kDefaultSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
        if (memory == MAP_FAILED) return nullptr;
        default_ = MemoryPool::create(memory, kDefaultSize);
        enter(default_, memory, kDefaultSize, true);
    }
    current_.store(default_, std::memory_order_release);
    return default_;
}

MemoryPool* PoolRegistry::madeOf(const void* memory) const noexcept {
    const unsigned count = count_.load(std::memory_order_acquire);
    for (unsigned i = 0; i != count; ++i) {
        MemoryPool* pool = areas_[i].pool.load(std::memory_order_acquire);
        if (pool && areas_[i].first.load(std::memory_order_relaxed) &&
            areas_[i].begin.load(std::memory_order_relaxed) == memory)
            return pool;
    }
    return nullptr;
}

MemoryPool* PoolRegistry::ownerOf(const void* block) const noexcept {
    const auto* address = static_cast<const char*>(block);
    // The latest first, because another pool may have been made of the memory of a destroyed one.
    bool known = false;
    for (unsigned i = count_.load(std::memory_order_acquire); i-- != 0;) {
        MemoryPool* pool = areas_[i].pool.load(std::memory_order_acquire);
        if (address < areas_[i].begin.load(std::memory_order_relaxed) ||
            address >= areas_[i].end.load(std::memory_order_relaxed))
            continue;
        if (pool) return pool;
        known = true;
    }
    if (known) return nullptr;
    const char text[] = "real-time memory: a block that was not allocated here\n";
    const auto ignored = write(STDERR_FILENO, text, sizeof text - 1);
    (void)ignored;
    std::abort();
}

void PoolRegistry::release(void* block) noexcept {
    if (!block) return;
    if (MemoryPool* pool = ownerOf(block)) pool->release(block);
}

/** True if another area can be entered. One that begins where a destroyed one did takes its place. */
bool PoolRegistry::hasRoom(const void* memory) const noexcept {
    const unsigned count = count_.load(std::memory_order_relaxed);
    for (unsigned i = 0; i != count; ++i)
        if (!areas_[i].pool.load(std::memory_order_relaxed) &&
            areas_[i].begin.load(std::memory_order_relaxed) == memory)
            return true;
    return count != kMaxAreas;
}

void PoolRegistry::enter(MemoryPool* pool, const void* memory, std::size_t size, bool first) noexcept {
    const unsigned count = count_.load(std::memory_order_relaxed);
    unsigned at = 0;
    while (at != count && (areas_[at].pool.load(std::memory_order_relaxed) ||
                           areas_[at].begin.load(std::memory_order_relaxed) != memory))
        ++at;
    const auto* begin = static_cast<const char*>(memory);
    areas_[at].begin.store(begin, std::memory_order_relaxed);
    areas_[at].end.store(begin + size, std::memory_order_relaxed);
    areas_[at].first.store(first, std::memory_order_relaxed);
    areas_[at].pool.store(pool, std::memory_order_release);
    if (at == count) count_.store(count + 1, std::memory_order_release);
}

std::size_t PoolRegistry::create(void* memory, std::size_t size) noexcept {
    Locked lock(changes_);
    if (MemoryPool* pool = madeOf(memory)) {
        current_.store(pool, std::memory_order_release);
        const MemoryPool::Usage usage = pool->usage();
        return usage.total - usage.used;
    }
    if (!hasRoom(memory)) return 0;
    MemoryPool* pool = MemoryPool::create(memory, size);
    if (!pool) return 0;
    enter(pool, memory, size, true);
    current_.store(pool, std::memory_order_release);
    const MemoryPool::Usage usage = pool->usage();
    return usage.total - usage.used - MemoryPool::kAlignment;  // the header of its one block
}

std::size_t PoolRegistry::extend(void* memory, void* area, std::size_t size) noexcept {
    Locked lock(changes_);
    MemoryPool* pool = madeOf(memory);
    if (!pool || !area || !hasRoom(area)) return 0;
    // Entered before the pool gets it, because then other threads allocate from it.
    enter(pool, area, size, false);
    const std::size_t usable = pool->addArea(area, size);
    if (usable == 0) {
        for (unsigned i = 0; i != count_.load(std::memory_order_relaxed); ++i)
            if (areas_[i].begin.load(std::memory_order_relaxed) == area)
                areas_[i].pool.store(nullptr, std::memory_order_release);
    }
    return usable;
}

void PoolRegistry::destroy(void* memory) noexcept {
    Locked lock(changes_);
    MemoryPool* pool = madeOf(memory);
    if (!pool) return;
    if (current_.load(std::memory_order_relaxed) == pool) current_.store(default_, std::memory_order_release);
    for (unsigned i = 0; i != count_.load(std::memory_order_relaxed); ++i)
        if (areas_[i].pool.load(std::memory_order_relaxed) == pool)
            areas_[i].pool.store(nullptr, std::memory_order_release);
    pool->~MemoryPool();
}

}  // namespace RTT::os::detail
