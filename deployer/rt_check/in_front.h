/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
#ifndef OROFORGE_RT_CHECK_IN_FRONT_H
#define OROFORGE_RT_CHECK_IN_FRONT_H

#include "interface.h"

/* Macros that define functions which replace functions of libc and call them. */
#ifdef __cplusplus
extern "C" {
#endif

/* Everything else is hidden. */
#define OROFORGE_IN_FRONT __attribute__((visibility("default")))

/* For the calling thread: the number of watched hooks around it, and of calls that are reported already (calls by libc
    inside them are not findings). Initial-exec, because access must not allocate. */
extern __thread int oroforge_rt_watched __attribute__((tls_model("initial-exec")));
extern __thread int oroforge_rt_inside __attribute__((tls_model("initial-exec")));

static inline int oroforge_rt_watching(void) { return oroforge_rt_watched != 0 && oroforge_rt_inside == 0; }

/* Counts a call, which returns to `caller`. Keeps errno. */
void oroforge_rt_note(enum oroforge_rt_fault fault, const char* function, const void* caller);
/* For a function that opens this file: counts devices, if the thread is watched. */
void oroforge_rt_note_path(const char* path, const char* function, const void* caller);
#define OROFORGE_NOTE_PATH(PATH, NAME) (oroforge_rt_note_path(PATH, NAME, __builtin_return_address(0)), 1)
/* Resolves the frames of all findings, before a library with some of them is unloaded. */
void oroforge_rt_resolve(void);
/* Must be called after a library was closed, because it may have been unloaded. */
void oroforge_rt_closed(void);

/* Non-zero if a call with this descriptor may block. */
int oroforge_rt_may_block(int fd);

/* The function of that name in the libraries after this one, cached in `slot`. Null only for a function that is needed
    for the look-up. Tries the version first: if libc has several versions of a function, dlsym() gives the oldest. */
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

/* Defines NAME. The call is counted if BLOCKS, an expression of the arguments, says that it may block. */
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

/* The same in two parts, for functions that need more than one expression. */
#define OROFORGE_COUNT(FAULT, NAME)                                                         \
    const int counted_ = oroforge_rt_watching();                                            \
    if (counted_) oroforge_rt_note(OROFORGE_RT_##FAULT, NAME, __builtin_return_address(0)); \
    oroforge_rt_inside += counted_
#define OROFORGE_COUNTED() oroforge_rt_inside -= counted_

#endif
#endif
