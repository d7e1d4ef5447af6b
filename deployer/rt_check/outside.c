/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
/* What else is not the same in each replay: random numbers and devices. Functions that keep the state of their generator
   in their arguments, such as rand_r(), are not among them. */
#include "in_front.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>

OROFORGE_WATCH(RANDOM, int, rand, (void), ())
OROFORGE_WATCH(RANDOM, long, random, (void), ())
OROFORGE_WATCH(RANDOM, double, drand48, (void), ())
OROFORGE_WATCH(RANDOM, long, lrand48, (void), ())
OROFORGE_WATCH(RANDOM, long, mrand48, (void), ())
OROFORGE_WATCH(RANDOM, ssize_t, getrandom, (void* to, size_t size, unsigned flags), (to, size, flags))
OROFORGE_WATCH(RANDOM, int, getentropy, (void* to, size_t size), (to, size))
#if __GLIBC_PREREQ(2, 36)
OROFORGE_WATCH(RANDOM, uint32_t, arc4random, (void), ())
OROFORGE_WATCH(RANDOM, uint32_t, arc4random_uniform, (uint32_t below), (below))
OROFORGE_IN_FRONT void arc4random_buf(void* to, size_t size) {
    OROFORGE_COUNT(RANDOM, "arc4random_buf");
    OROFORGE_NEXT_OF(arc4random_buf, 0)(to, size);
    OROFORGE_COUNTED();
}
#endif

/* std::random_device::operator()(), which may ask the processor. */
extern unsigned _ZNSt13random_device9_M_getvalEv(void* device);
OROFORGE_IN_FRONT unsigned _ZNSt13random_device9_M_getvalEv(void* device) {
    OROFORGE_COUNT(RANDOM, "std::random_device");
    const unsigned result = OROFORGE_NEXT_OF(_ZNSt13random_device9_M_getvalEv, 0)(device);
    OROFORGE_COUNTED();
    return result;
}

static int begins(const char* path, const char* with) { return strncmp(path, with, strlen(with)) == 0; }

void oroforge_rt_note_path(const char* path, const char* function, const void* caller) {
    static const char* const same[] = {"/dev/null", "/dev/zero",   "/dev/full",  "/dev/shm/",
                                       "/dev/fd/",  "/dev/stdout", "/dev/stderr"};
    if (!path || !begins(path, "/dev/")) return;
    for (unsigned i = 0; i != sizeof same / sizeof *same; ++i)
        if (begins(path, same[i])) return;
    const int is_random = begins(path, "/dev/random") || begins(path, "/dev/urandom");
    oroforge_rt_note(is_random ? OROFORGE_RT_RANDOM : OROFORGE_RT_DEVICE, function, caller);
}
