// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/oro_malloc.h>

#include <rtt/os/detail/pool_registry.hpp>
#include <rtt/os/os_log.hpp>
#include <rtt/os/tlsf/tlsf.h>

#include <atomic>
#include <cstdio>
#include <cstring>
#include <exception>

using RTT::os::detail::MemoryPool;
using RTT::os::detail::PoolRegistry;

namespace {

PoolRegistry& pools() noexcept { return PoolRegistry::instance(); }

/** The smallest size for which allocation failed, reset when a block of that size is allocated again; 0 if none. */
std::atomic<std::size_t> refusedSize{0};

/** Real-time safe in real-time threads. */
void reportExhausted(const MemoryPool& pool, std::size_t size) noexcept {
    const MemoryPool::Usage usage = pool.usage();
    char text[128];
    const int length =
        std::snprintf(text, sizeof text, "no real-time memory for %zu bytes: %zu of %zu bytes are in use", size,
                      usage.used, usage.total);
    try {
        RTT::os::detail::log(RTT::os::detail::LogError, "Memory", {text, static_cast<std::size_t>(length)});
    } catch (const std::exception&) {
        // The caller gets a null pointer in any case.
    }
}

/** Returns the block. Logs once that memory is used up, not for each failing call. */
void* noted(const MemoryPool& pool, std::size_t size, void* block) noexcept {
    // Relaxed: threads that fail at the same time may both report.
    std::size_t refused = refusedSize.load(std::memory_order_relaxed);
    if (block) {
        if (refused != 0 && size >= refused) refusedSize.compare_exchange_strong(refused, 0, std::memory_order_relaxed);
    } else if (refused == 0 || size < refused) {
        refusedSize.store(size, std::memory_order_relaxed);
        reportExhausted(pool, size);
    }
    return block;
}

void* allocate(MemoryPool* pool, std::size_t size) noexcept {
    return pool ? noted(*pool, size, pool->allocate(size)) : nullptr;
}

void* allocateZeros(MemoryPool* pool, std::size_t count, std::size_t size) noexcept {
    std::size_t total = 0;
    if (__builtin_mul_overflow(count, size, &total)) return nullptr;
    void* block = allocate(pool, total);
    if (block) std::memset(block, 0, total);
    return block;
}

/** `pool` is for a new block; an existing one stays in its own pool. */
void* resize(MemoryPool* pool, void* block, std::size_t size) noexcept {
    if (!block) return allocate(pool, size);
    if (size == 0) {
        pools().release(block);
        return nullptr;
    }
    MemoryPool* owner = pools().ownerOf(block);
    if (!owner) return nullptr;
    return noted(*owner, size, owner->resize(block, size));
}

MemoryPool::Usage usageOf(const MemoryPool* pool) noexcept {
    return pool ? pool->usage() : MemoryPool::Usage{0, 0, 0, 0};
}
MemoryPool::Usage usageAt(const void* memory) noexcept { return usageOf(pools().madeOf(memory)); }

}  // namespace

void* oro_rt_malloc(size_t size) { return allocate(pools().current(), size); }
void* oro_rt_calloc(size_t count, size_t size) { return allocateZeros(pools().current(), count, size); }
void* oro_rt_realloc(void* block, size_t size) { return resize(block ? nullptr : pools().current(), block, size); }
void oro_rt_free(void* block) { pools().release(block); }

void* tlsf_malloc(size_t size) { return oro_rt_malloc(size); }
void* tlsf_calloc(size_t count, size_t size) { return oro_rt_calloc(count, size); }
void* tlsf_realloc(void* block, size_t size) { return oro_rt_realloc(block, size); }
void tlsf_free(void* block) { oro_rt_free(block); }

size_t init_memory_pool(size_t size, void* pool) { return pools().create(pool, size); }
size_t add_new_area(void* area, size_t size, void* pool) { return pools().extend(pool, area, size); }
void destroy_memory_pool(void* pool) { pools().destroy(pool); }

void* malloc_ex(size_t size, void* pool) { return allocate(pools().madeOf(pool), size); }
void* calloc_ex(size_t count, size_t size, void* pool) { return allocateZeros(pools().madeOf(pool), count, size); }
void* realloc_ex(void* block, size_t size, void* pool) { return resize(pools().madeOf(pool), block, size); }
void free_ex(void* block, void*) { pools().release(block); }

size_t get_pool_size(void* pool) { return usageAt(pool).total; }
size_t get_overhead_size(void* pool) { return usageAt(pool).overhead; }
size_t get_used_size(void* pool) { return usageAt(pool).used; }
size_t get_max_size(void* pool) { return usageAt(pool).maxUsed; }

size_t get_pool_size_mp(void) { return usageOf(pools().current()).total; }
size_t get_overhead_size_mp(void) { return usageOf(pools().current()).overhead; }
size_t get_used_size_mp(void) { return usageOf(pools().current()).used; }
size_t get_max_size_mp(void) { return usageOf(pools().current()).maxUsed; }
