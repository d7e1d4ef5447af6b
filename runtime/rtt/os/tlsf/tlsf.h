/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
#ifndef ORO_OS_TLSF_H
#define ORO_OS_TLSF_H

/**
 * @file
 * Pools of real-time memory, with the names of the TLSF allocator. A pool is identified by the memory of which it was
 * made. oro_rt_malloc() (here: tlsf_malloc()) allocates from the pool that was made last.
 *
 * Functions that allocate and free are as real-time safe as those of <rtt/os/oro_malloc.h>. Those that make, extend and
 * destroy pools are not; any thread may call them, but a pool in use must not be destroyed.
 */
#include <rtt/os/oro_malloc.h>
#include <rtt/rtt-config.h>

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Makes a pool of `size` bytes at `pool`, which the caller owns and must not touch until the pool is destroyed. Returns
 * how many bytes can be allocated; 0 if it is too small (below 8 KiB) or there are more than 64 areas already. If the
 * pool exists already, memory is allocated from it again.
 */
RTT_API size_t init_memory_pool(size_t size, void* pool);
/** Adds an area to a pool. Returns how many bytes of it can be allocated; 0 if it cannot be added. */
RTT_API size_t add_new_area(void* area, size_t size, void* pool);
/**
 * Forgets the pool; its memory is the caller's again. Blocks that are still allocated must not be used any more, but
 * may be freed, which does nothing. Memory is allocated from the pool of 512 KiB again.
 */
RTT_API void destroy_memory_pool(void* pool);

RTT_API void* malloc_ex(size_t size, void* pool);
RTT_API void* calloc_ex(size_t count, size_t size, void* pool);
RTT_API void* realloc_ex(void* block, size_t size, void* pool);
RTT_API void free_ex(void* block, void* pool);

RTT_API void* tlsf_malloc(size_t size);
RTT_API void* tlsf_calloc(size_t count, size_t size);
RTT_API void* tlsf_realloc(void* block, size_t size);
RTT_API void tlsf_free(void* block);

/** Bytes of all areas; of these, the overhead of an empty pool; in use, with the overhead; and the most ever in use. 0
    if there is no such pool. */
RTT_API size_t get_pool_size(void* pool);
RTT_API size_t get_overhead_size(void* pool);
RTT_API size_t get_used_size(void* pool);
RTT_API size_t get_max_size(void* pool);

/** The same for the pool from which memory is allocated now. */
RTT_API size_t get_pool_size_mp(void);
RTT_API size_t get_overhead_size_mp(void);
RTT_API size_t get_used_size_mp(void);
RTT_API size_t get_max_size_mp(void);

#ifdef __cplusplus
}
#endif
#endif
