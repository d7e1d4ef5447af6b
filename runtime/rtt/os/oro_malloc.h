/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
#ifndef ORO_OS_MALLOC_H
#define ORO_OS_MALLOC_H

/**
 * @file
 * Memory for real-time threads: what malloc() and its siblings do, out of a pool that was set aside before.
 *
 * Every function takes a constant number of steps, whatever the size (but oro_rt_calloc() fills and oro_rt_realloc()
 * may copy what is asked for), and never calls the system. Any thread. They hold a mutex that inherits priority for a
 * bounded number of instructions: real-time safe in that sense, but not lock-free. Blocks are aligned to 16 bytes and
 * cost 16 bytes more than asked for. There is no growing: a pool that is full gives a null pointer, and an error line in
 * the log; the next line comes after a block of that size could be had in the meantime, or when there is none for a
 * smaller one.
 *
 * __os_init() sets aside 512 KiB unless init_memory_pool() of <rtt/os/tlsf/tlsf.h> gave a pool before. Without either
 * the first call sets them aside, and only that one asks the system.
 */
#include <rtt/rtt-config.h>

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

RTT_API void* oro_rt_malloc(size_t size);
/** Room for count objects, filled with zeros. */
RTT_API void* oro_rt_calloc(size_t count, size_t size);
/** Null if there is no room; the old block is untouched then. Size 0 frees and returns null. */
RTT_API void* oro_rt_realloc(void* block, size_t size);
/**
 * Null does nothing, nor does a block of a pool that was destroyed since. A block that was freed before or comes
 * from elsewhere ends the process with a message.
 */
RTT_API void oro_rt_free(void* block);

#ifdef __cplusplus
}
#endif
#endif
