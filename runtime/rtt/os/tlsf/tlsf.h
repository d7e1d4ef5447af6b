/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
#ifndef ORO_OS_TLSF_H
#define ORO_OS_TLSF_H

/**
 * @file
 * Pools of real-time memory under the names of the TLSF allocator. A pool is known by the memory that it was made of.
 * The pool made last is the one that oro_rt_malloc() (here: tlsf_malloc()) takes memory from.
 *
 * Functions that allocate and free are as real-time safe as those of <rtt/os/oro_malloc.h>. Making, extending and
 * destroying pools is not; it may be done by any thread, destroying only when nobody uses the pool.
 */
#include <rtt/os/oro_malloc.h>
#include <rtt/rtt-config.h>

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Makes a pool of `size` bytes at `pool`, which the caller owns and must not touch until it is destroyed. Returns
 * how many bytes can be allocated, 0 if it is too small (below 8 KiB) or there are more than 64 areas already. A pool
 * that exists already becomes the one that memory is taken from.
 */
RTT_API size_t init_memory_pool(size_t size, void* pool);
/** Gives a pool another area. Returns how many bytes of it can be allocated, 0 if that is not possible. */
RTT_API size_t add_new_area(void* area, size_t size, void* pool);
/**
 * Forgets the pool; its memory is the caller's again. Blocks that are still out must not be used any more, but may be
 * freed, which then does nothing. Memory is taken from the pool of 512 KiB again.
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

/** Bytes of all areas; of these, what bookkeeping takes in an empty pool; what is in use, with the bookkeeping; and the
    most that ever was. 0 for what is no pool. */
RTT_API size_t get_pool_size(void* pool);
RTT_API size_t get_overhead_size(void* pool);
RTT_API size_t get_used_size(void* pool);
RTT_API size_t get_max_size(void* pool);

/** The same of the pool that memory is taken from now. */
RTT_API size_t get_pool_size_mp(void);
RTT_API size_t get_overhead_size_mp(void);
RTT_API size_t get_used_size_mp(void);
RTT_API size_t get_max_size_mp(void);

#ifdef __cplusplus
}
#endif
#endif
