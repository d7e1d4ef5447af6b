// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_FOSI_SYNC_H
#define ORO_FOSI_SYNC_H

/**
 * @file
 * Mutexes, condition variables and semaphores in C, for code that was written against the lowest layer. In C++,
 * os::Mutex, os::Condition and os::Semaphore are easier. Functions return 0 or a POSIX error number; those for
 * semaphores return -1 and set errno. Times are those of rtos_get_time_ns(). Mutexes inherit priorities.
 */
#include <rtt/os/fosi_base.h>

#include <errno.h>
#include <pthread.h>
#include <semaphore.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef pthread_mutex_t rt_mutex_t;
typedef pthread_mutex_t rt_rec_mutex_t;
typedef pthread_cond_t rt_cond_t;
typedef sem_t rt_sem_t;

/* Waits on the monotonic clock are GNU functions, which plain C does not declare and ThreadSanitizer does not know. */
#if defined(_GNU_SOURCE) && !defined(__SANITIZE_THREAD__)
#if !defined(__has_feature)
#define ORO_MONOTONIC_WAITS
#elif !__has_feature(thread_sanitizer)
#define ORO_MONOTONIC_WAITS
#endif
#endif

static inline TIME_SPEC oro_wall_time(NANO_TIME until) {
    TIME_SPEC now;
    clock_gettime(CLOCK_REALTIME, &now);
    return ticks2timespec(now.tv_sec * 1000000000LL + now.tv_nsec + until - rtos_get_time_ns());
}

static inline int oro_mutex_init_as(pthread_mutex_t* m, int type) {
    pthread_mutexattr_t attributes;
    int error = pthread_mutexattr_init(&attributes);
    if (error != 0) return error;
    pthread_mutexattr_settype(&attributes, type);
    pthread_mutexattr_setprotocol(&attributes, PTHREAD_PRIO_INHERIT);
    error = pthread_mutex_init(m, &attributes);
    pthread_mutexattr_destroy(&attributes);
    return error;
}

static inline int rtos_mutex_init(rt_mutex_t* m) { return oro_mutex_init_as(m, PTHREAD_MUTEX_NORMAL); }
static inline int rtos_mutex_destroy(rt_mutex_t* m) { return pthread_mutex_destroy(m); }
static inline int rtos_mutex_lock(rt_mutex_t* m) { return pthread_mutex_lock(m); }
/** Returns 0 if it locked the mutex. */
static inline int rtos_mutex_trylock(rt_mutex_t* m) { return pthread_mutex_trylock(m); }
static inline int rtos_mutex_unlock(rt_mutex_t* m) { return pthread_mutex_unlock(m); }
/** Returns ETIMEDOUT if that time came first. */
static inline int rtos_mutex_lock_until(rt_mutex_t* m, NANO_TIME until) {
#ifdef ORO_MONOTONIC_WAITS
    const TIME_SPEC deadline = ticks2timespec(until);
    const int error = pthread_mutex_clocklock(m, CLOCK_MONOTONIC, &deadline);
    /* For a mutex that inherits priorities, kernels before 5.14 support only the wall clock. */
    if (error != EINVAL) return error;
#endif
    const TIME_SPEC wall = oro_wall_time(until);
    return pthread_mutex_timedlock(m, &wall);
}

/** A thread may lock it several times. */
static inline int rtos_mutex_rec_init(rt_rec_mutex_t* m) { return oro_mutex_init_as(m, PTHREAD_MUTEX_RECURSIVE); }
static inline int rtos_mutex_rec_destroy(rt_rec_mutex_t* m) { return pthread_mutex_destroy(m); }
static inline int rtos_mutex_rec_lock(rt_rec_mutex_t* m) { return pthread_mutex_lock(m); }
static inline int rtos_mutex_rec_trylock(rt_rec_mutex_t* m) { return pthread_mutex_trylock(m); }
static inline int rtos_mutex_rec_unlock(rt_rec_mutex_t* m) { return pthread_mutex_unlock(m); }
static inline int rtos_mutex_rec_lock_until(rt_rec_mutex_t* m, NANO_TIME until) {
    return rtos_mutex_lock_until(m, until);
}

static inline int rtos_cond_init(rt_cond_t* c) { return pthread_cond_init(c, NULL); }
static inline int rtos_cond_destroy(rt_cond_t* c) { return pthread_cond_destroy(c); }
static inline int rtos_cond_wait(rt_cond_t* c, rt_mutex_t* m) { return pthread_cond_wait(c, m); }
static inline int rtos_cond_timedwait(rt_cond_t* c, rt_mutex_t* m, NANO_TIME until) {
#ifdef ORO_MONOTONIC_WAITS
    const TIME_SPEC deadline = ticks2timespec(until);
    return pthread_cond_clockwait(c, m, CLOCK_MONOTONIC, &deadline);
#else
    const TIME_SPEC wall = oro_wall_time(until);
    return pthread_cond_timedwait(c, m, &wall);
#endif
}
static inline int rtos_cond_broadcast(rt_cond_t* c) { return pthread_cond_broadcast(c); }

static inline int rtos_sem_init(rt_sem_t* s, int value) { return sem_init(s, 0, (unsigned)value); }
static inline int rtos_sem_destroy(rt_sem_t* s) { return sem_destroy(s); }
static inline int rtos_sem_signal(rt_sem_t* s) { return sem_post(s); }
static inline int rtos_sem_wait(rt_sem_t* s) { return sem_wait(s); }
static inline int rtos_sem_trywait(rt_sem_t* s) { return sem_trywait(s); }
static inline int rtos_sem_wait_until(rt_sem_t* s, NANO_TIME until) {
#ifdef ORO_MONOTONIC_WAITS
    const TIME_SPEC deadline = ticks2timespec(until);
    return sem_clockwait(s, CLOCK_MONOTONIC, &deadline);
#else
    const TIME_SPEC wall = oro_wall_time(until);
    return sem_timedwait(s, &wall);
#endif
}
static inline int rtos_sem_wait_timed(rt_sem_t* s, NANO_TIME delay) {
    return rtos_sem_wait_until(s, rtos_get_time_ns() + delay);
}
static inline int rtos_sem_value(rt_sem_t* s) {
    int value = 0;
    return sem_getvalue(s, &value) == 0 ? value : 0;
}

#ifdef __cplusplus
}
#endif
#endif
