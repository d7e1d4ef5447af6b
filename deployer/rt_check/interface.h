/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
#ifndef OROFORGE_RT_CHECK_INTERFACE_H
#define OROFORGE_RT_CHECK_INTERFACE_H

/*
 * Between a program and the library that stands in front of libc's functions when the program is started with it preloaded
 * (deployer --rt-check). The program does not link the library: it asks the dynamic linker for these functions.
 */
#ifdef __cplusplus
extern "C" {
#endif

/* What a real-time component must not do. */
enum oroforge_rt_fault {
    OROFORGE_RT_ALLOCATION = 1,
    OROFORGE_RT_RELEASE = 2,
    OROFORGE_RT_LOCK = 3,
    OROFORGE_RT_WAIT = 4,
    OROFORGE_RT_SYSTEM_CALL = 5,
    OROFORGE_RT_STREAM = 6
};

/* What a component's thread executes for it. */
enum oroforge_rt_place {
    OROFORGE_RT_UPDATE,    /* updateHook() */
    OROFORGE_RT_ERROR,     /* errorHook() */
    OROFORGE_RT_CALLBACK,  /* of a port */
    OROFORGE_RT_OPERATION, /* that somebody else has called or sent */
    OROFORGE_RT_SCRIPT,    /* a step of one, or of another function */
    OROFORGE_RT_PLACES
};

/* Calls of one function from one place. The texts live until the next call of oroforge_rt_check_findings(). */
struct oroforge_rt_finding {
    const char* component;
    enum oroforge_rt_place place;
    enum oroforge_rt_fault fault;
    const char* function; /* that was called */
    unsigned long count;
    unsigned depth;
    const char* const* frames; /* of the first call, the innermost first */
};

/* The calling thread begins and ends one of these. They nest; within a watched one all are watched. */
void oroforge_rt_check_begin(const char* component, enum oroforge_rt_place place, int real_time);
void oroforge_rt_check_end(void);

struct oroforge_rt_totals {
    unsigned long executions[OROFORGE_RT_PLACES]; /* of what is watched */
    unsigned long lost;                           /* calls for which there was no room */
};
typedef void (*oroforge_rt_visitor)(void* to, const struct oroforge_rt_finding* finding);
/* Hands over what was found so far, ordered by component, place, fault, and number of calls. For one thread at a time. */
struct oroforge_rt_totals oroforge_rt_check_findings(oroforge_rt_visitor visit, void* to);

#ifdef __cplusplus
}
#endif
#endif
