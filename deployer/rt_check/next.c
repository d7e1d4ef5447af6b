/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
/* Finds what stands behind our functions; and those that would disturb the watch. */
#include "in_front.h"

#include <dlfcn.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>

static __thread int searching __attribute__((tls_model("initial-exec")));

void* oroforge_rt_next(void** slot, const char* name, const char* version) {
    void* found = __atomic_load_n(slot, __ATOMIC_RELAXED);
    if (found || searching) return found;
    ++searching;
    if (version) found = dlvsym(RTLD_NEXT, name, version);
    if (!found) found = dlsym(RTLD_NEXT, name);
    --searching;
    if (!found) {
        fprintf(stderr, "--rt-check: no library has the function %s\n", name);
        abort();
    }
    __atomic_store_n(slot, found, __ATOMIC_RELAXED);
    return found;
}

/* What is in a library can be told only while it is there. */
OROFORGE_IN_FRONT int dlclose(void* library) {
    const __typeof__(&dlclose) next_ = OROFORGE_NEXT_OF(dlclose, 0);
    OROFORGE_COUNT(SYSTEM_CALL, "dlclose");
    ++oroforge_rt_inside;
    oroforge_rt_resolve();
    --oroforge_rt_inside;
    const int result = next_(library);
    oroforge_rt_closed();
    OROFORGE_COUNTED();
    return result;
}

/* A component that is watched is treated as one with the privilege, which it may lack where it is checked: who asks
   whether it is a real-time thread (the logger does) takes the way that it will take then. */
OROFORGE_IN_FRONT int sched_getscheduler(pid_t thread) {
    if (thread == 0 && oroforge_rt_watched != 0) return SCHED_FIFO;
    return OROFORGE_NEXT_OF(sched_getscheduler, 0)(thread);
}
