// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_FOSI_BASE_H
#define ORO_FOSI_BASE_H

/**
 * @file
 * The part of <rtt/os/fosi.h> that all others need: schedulers, wait policies, time types and the monotonic clock.
 */
#include <rtt/rtt-config.h>

#include <errno.h>
#include <pthread.h>
#include <sched.h>
#include <stdio.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

/** Schedulers of threads and activities. SCHED_RR is accepted as well. */
#define ORO_SCHED_RT SCHED_FIFO
#define ORO_SCHED_OTHER SCHED_OTHER

/**
 * How a periodic thread computes its next wake-up: ABS adds the period to the previous wake-up, so that late cycles are
 * caught up back to back; REL adds it to the moment when the thread really woke up.
 */
#define ORO_WAIT_ABS 0
#define ORO_WAIT_REL 1

/** Writes to the standard output as printf() does; not real-time safe. */
#define rtos_printf printf

#ifdef __cplusplus
extern "C" {
#endif

typedef long long NANO_TIME;
typedef long long TICK_TIME;
typedef struct timespec TIME_SPEC;

/** Identifies a thread of the operating system. */
typedef struct {
    pthread_t thread; /* valid for threads made by os::Thread only */
    pid_t pid;        /* Linux thread id */
} RTOS_TASK;

/** Nanoseconds of CLOCK_MONOTONIC: never set back, not affected by changes of the wall clock. */
static inline NANO_TIME rtos_get_time_ns(void) {
    TIME_SPEC now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (NANO_TIME)now.tv_sec * 1000000000LL + now.tv_nsec;
}

/** A tick is a nanosecond here. */
static inline TICK_TIME rtos_get_time_ticks(void) { return rtos_get_time_ns(); }
static inline TICK_TIME nano2ticks(NANO_TIME t) { return t; }
static inline NANO_TIME ticks2nano(TICK_TIME t) { return t; }

/** Splits a non-negative number of nanoseconds. */
static inline TIME_SPEC ticks2timespec(TICK_TIME t) {
    TIME_SPEC result;
    result.tv_sec = (time_t)(t / 1000000000LL);
    result.tv_nsec = (long)(t % 1000000000LL);
    return result;
}

/** Blocks for that long on the monotonic clock and returns 0. If a signal comes first, returns -1 and stores the
    remaining time in `*remaining`, which may be null. */
static inline int rtos_nanosleep(const TIME_SPEC* duration, TIME_SPEC* remaining) {
    const int error = clock_nanosleep(CLOCK_MONOTONIC, 0, duration, remaining);
    if (error != 0) errno = error;
    return error == 0 ? 0 : -1;
}

#ifdef __cplusplus
}
#endif

#endif
