/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
#ifndef OROFORGE_RT_CHECK_IN_FRONT_H
#define OROFORGE_RT_CHECK_IN_FRONT_H

#include "interface.h"

/* How a function is written that stands in front of one of libc's. */
#ifdef __cplusplus
extern "C" {
#endif

/* Everything else is hidden. */
#define OROFORGE_IN_FRONT __attribute__((visibility("default")))

/* Of the calling thread: within how many watched hooks it is, and within how many calls that are reported already (what
   libc does for them is no finding of its own). Initial-exec: to look at them must not allocate. */
extern __thread int oroforge_rt_watched __attribute__((tls_model("initial-exec")));
extern __thread int oroforge_rt_inside __attribute__((tls_model("initial-exec")));

static inline int oroforge_rt_watching(void) { return oroforge_rt_watched != 0 && oroforge_rt_inside == 0; }

/* Counts a call; `caller` is where it returns to. Keeps errno. */
void oroforge_rt_note(enum oroforge_rt_fault fault, const char* function, const void* caller);
/* Finds out what the frames of all findings are, before the library that they are in may go. */
void oroforge_rt_resolve(void);
/* After a library was closed, and may have gone. */
void oroforge_rt_closed(void);

/* Whether a call that uses this descriptor may block. */
int oroforge_rt_may_block(int fd);

/* The function of that name in the libraries behind this one, kept in `slot`. Null only for a function that is
   needed to find it. A version is tried first, for functions of which libc has older ones: of these, dlsym() gives the oldest. */
void* oroforge_rt_next(void** slot, const char* name, const char* version);

#ifdef __cplusplus
}
#endif

#ifndef __cplusplus

#define OROFORGE_NEXT_OF(NAME, VERSION)                              \
    __extension__({                                                  \
        static void* slot_;                                          \
        (__typeof__(&NAME))oroforge_rt_next(&slot_, #NAME, VERSION); \
    })

/* Defines NAME. BLOCKS tells of the arguments whether this call may block; if so it is counted. */
#define OROFORGE_WATCH_VERSION(FAULT, VERSION, RESULT, NAME, PARAMETERS, ARGUMENTS, BLOCKS) \
    OROFORGE_IN_FRONT RESULT NAME PARAMETERS {                                              \
        const __typeof__(&NAME) next_ = OROFORGE_NEXT_OF(NAME, VERSION);                    \
        if (!oroforge_rt_watching() || !(BLOCKS)) return next_ ARGUMENTS;                   \
        oroforge_rt_note(OROFORGE_RT_##FAULT, #NAME, __builtin_return_address(0));          \
        ++oroforge_rt_inside;                                                               \
        RESULT result_ = next_ ARGUMENTS;                                                   \
        --oroforge_rt_inside;                                                               \
        return result_;                                                                     \
    }
#define OROFORGE_WATCH_IF(FAULT, RESULT, NAME, PARAMETERS, ARGUMENTS, BLOCKS) \
    OROFORGE_WATCH_VERSION(FAULT, 0, RESULT, NAME, PARAMETERS, ARGUMENTS, BLOCKS)
#define OROFORGE_WATCH(FAULT, RESULT, NAME, PARAMETERS, ARGUMENTS) \
    OROFORGE_WATCH_VERSION(FAULT, 0, RESULT, NAME, PARAMETERS, ARGUMENTS, 1)

/* The same in two halves, for functions that need more than one expression. */
#define OROFORGE_COUNT(FAULT, NAME)                                                         \
    const int counted_ = oroforge_rt_watching();                                            \
    if (counted_) oroforge_rt_note(OROFORGE_RT_##FAULT, NAME, __builtin_return_address(0)); \
    oroforge_rt_inside += counted_
#define OROFORGE_COUNTED() oroforge_rt_inside -= counted_

#endif
#endif
