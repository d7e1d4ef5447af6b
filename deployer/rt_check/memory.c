/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
/* The heap. Operators new and delete of the C++ library come here too. */
#include "in_front.h"

#include <malloc.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

/* libc's own: while the others are being looked for. */
extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void __libc_free(void*);

/* Other than what blocks, these do nothing that would be counted a second time: the call can be the last thing done. */
#define NOTE(FAULT, NAME) \
    if (oroforge_rt_watching()) oroforge_rt_note(OROFORGE_RT_##FAULT, NAME, __builtin_return_address(0))

OROFORGE_IN_FRONT void* malloc(size_t size) {
    const __typeof__(&malloc) next_ = OROFORGE_NEXT_OF(malloc, 0);
    NOTE(ALLOCATION, "malloc");
    return next_ ? next_(size) : __libc_malloc(size);
}

OROFORGE_IN_FRONT void* calloc(size_t count, size_t size) {
    const __typeof__(&calloc) next_ = OROFORGE_NEXT_OF(calloc, 0);
    NOTE(ALLOCATION, "calloc");
    return next_ ? next_(count, size) : __libc_calloc(count, size);
}

OROFORGE_IN_FRONT void* realloc(void* block, size_t size) {
    const __typeof__(&realloc) next_ = OROFORGE_NEXT_OF(realloc, 0);
    NOTE(ALLOCATION, "realloc");
    return next_ ? next_(block, size) : __libc_realloc(block, size);
}

OROFORGE_IN_FRONT void free(void* block) {
    if (!block) return;
    const __typeof__(&free) next_ = OROFORGE_NEXT_OF(free, 0);
    NOTE(RELEASE, "free");
    if (next_)
        next_(block);
    else
        __libc_free(block);
}

/* clang-format off */
OROFORGE_WATCH(ALLOCATION, void*, reallocarray, (void* block, size_t count, size_t size), (block, count, size))
OROFORGE_WATCH(ALLOCATION, void*, memalign, (size_t alignment, size_t size), (alignment, size))
OROFORGE_WATCH(ALLOCATION, void*, aligned_alloc, (size_t alignment, size_t size), (alignment, size))
OROFORGE_WATCH(ALLOCATION, void*, valloc, (size_t size), (size))
OROFORGE_WATCH(ALLOCATION, void*, pvalloc, (size_t size), (size))
OROFORGE_WATCH(ALLOCATION, int, posix_memalign, (void** block, size_t alignment, size_t size), (block, alignment, size))
OROFORGE_WATCH(ALLOCATION, void*, mmap, (void* at, size_t size, int access, int flags, int fd, off_t from), (at, size, access, flags, fd, from))
OROFORGE_WATCH(ALLOCATION, void*, mmap64, (void* at, size_t size, int access, int flags, int fd, off64_t from), (at, size, access, flags, fd, from))
OROFORGE_WATCH(ALLOCATION, void*, sbrk, (intptr_t more), (more))
OROFORGE_WATCH(ALLOCATION, int, mlock, (const void* at, size_t size), (at, size))
OROFORGE_WATCH(ALLOCATION, int, mlockall, (int flags), (flags))
OROFORGE_WATCH(RELEASE, int, munmap, (void* at, size_t size), (at, size))
/* clang-format on */

OROFORGE_IN_FRONT void* mremap(void* block, size_t size, size_t wanted, int flags, ...) {
    va_list list;
    va_start(list, flags);
    void* const to = va_arg(list, void*);
    va_end(list);
    const __typeof__(&mremap) next_ = OROFORGE_NEXT_OF(mremap, 0);
    NOTE(ALLOCATION, "mremap");
    return next_(block, size, wanted, flags, to);
}
