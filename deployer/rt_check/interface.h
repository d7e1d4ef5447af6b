/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
#ifndef OROFORGE_RT_CHECK_INTERFACE_H
#define OROFORGE_RT_CHECK_INTERFACE_H

/*
 * The interface between a program and the library that replaces functions of libc when it is preloaded (deployer
 * --rt-check). The program does not link the library; it looks these functions up by the dynamic linker.
 */
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Faults of a real-time component, and of one that is to do the same in each replay. */
enum oroforge_rt_fault {
    OROFORGE_RT_ALLOCATION = 1,
    OROFORGE_RT_RELEASE = 2,
    OROFORGE_RT_LOCK = 3,
    OROFORGE_RT_WAIT = 4,
    OROFORGE_RT_SYSTEM_CALL = 5,
    OROFORGE_RT_STREAM = 6,
    OROFORGE_RT_THREAD = 7, /* a system call that may block, too */
    OROFORGE_RT_CLOCK = 8,
    OROFORGE_RT_RANDOM = 9,
    OROFORGE_RT_DEVICE = 10
};

/* The kinds of user code that a component's thread executes. */
enum oroforge_rt_place {
    OROFORGE_RT_UPDATE,    /* updateHook() */
    OROFORGE_RT_ERROR,     /* errorHook() */
    OROFORGE_RT_CALLBACK,  /* a callback of a port */
    OROFORGE_RT_OPERATION, /* an operation that another component has called or sent */
    OROFORGE_RT_SCRIPT,    /* a step of a script or of another function */
    OROFORGE_RT_CONFIGURE, /* configureHook() */
    OROFORGE_RT_START,     /* startHook() */
    OROFORGE_RT_CONSTRUCTOR,
    OROFORGE_RT_PLACES
};

/* Calls of one function from one place. The texts live until the next call of oroforge_rt_check_findings(). */
struct oroforge_rt_finding {
    const char* component;
    enum oroforge_rt_place place;
    enum oroforge_rt_fault fault;
    const char* function; /* the called function */
    unsigned long count;
    unsigned depth;
    const char* const* frames; /* the frames of the first call, the innermost first */
    const char* script;        /* "file:line" of the script that called; empty if there is none */
};

/* Writes "file:line" of the script that this thread executes, or an empty text. Neither allocates nor waits. */
typedef void (*oroforge_rt_script)(char* text, size_t size);
void oroforge_rt_check_scripts(oroforge_rt_script describe);

/* Called when the thread begins and ends such code. They nest; within watched code everything is watched. */
void oroforge_rt_check_begin(const char* component, enum oroforge_rt_place place, int real_time);
void oroforge_rt_check_end(void);

/* From now on only these faults are counted: bits, 1 << OROFORGE_RT_LOCK and so on. At first, those of a real-time
   component. */
void oroforge_rt_check_only(unsigned faults);

struct oroforge_rt_totals {
    unsigned long executions[OROFORGE_RT_PLACES]; /* executions of watched code */
    unsigned long lost;                           /* calls for which there was no room */
};
typedef void (*oroforge_rt_visitor)(void* to, const struct oroforge_rt_finding* finding);
/* Visits the findings so far, ordered by component, place, fault and number of calls. Called by one thread at a time.
     */
struct oroforge_rt_totals oroforge_rt_check_findings(oroforge_rt_visitor visit, void* to);

#ifdef __cplusplus
}
#endif
#endif
