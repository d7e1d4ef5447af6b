/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
#ifndef ORO_OS_MALLOC_H
#define ORO_OS_MALLOC_H

/**
 * @file
 * Memory for real-time threads: malloc() and its siblings, with memory from a pool that is reserved in advance.
 *
 * Any thread may call the functions. Each takes a constant number of steps, whatever the size, apart from filling the
 * block (oro_rt_calloc()) or copying it (oro_rt_realloc()), and never asks the system for memory. They hold a mutex
 * that inherits priority for a bounded number of instructions: in that sense they are real-time safe, but they are not
 * lock-free. Blocks are aligned to 16 bytes and take 16 bytes more than asked for. Pools do not grow: a full one gives
 * a null pointer and an error in the log. The error is repeated only after a block of that size could be allocated
 * again, or for a smaller one.
 *
 * __os_init() reserves 512 KiB unless init_memory_pool() of <rtt/os/tlsf/tlsf.h> was called before. Without either, the
 * first allocation reserves them with a system call.
 */
#include <rtt/rtt-config.h>

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

RTT_API void* oro_rt_malloc(size_t size);
/** Allocates zeroed memory for count objects. */
RTT_API void* oro_rt_calloc(size_t count, size_t size);
/** Changes the size of a block. Null if there is no room; the old block then stays valid. Size 0 frees and returns
    null. */
RTT_API void* oro_rt_realloc(void* block, size_t size);
/**
 * Does nothing for null and for a block of a destroyed pool. For a block that is already free or comes from elsewhere,
 * ends the process with a message.
 */
RTT_API void oro_rt_free(void* block);

#ifdef __cplusplus
}
#endif
#endif
