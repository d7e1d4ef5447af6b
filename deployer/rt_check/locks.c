/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
/*
 * Locks, and what waits for another thread, a time or a signal. A lock counts whether or not somebody has it just then: in
 * another cycle somebody will. What only tries counts for nothing, nor does a wait that gives up at once.
 */
#include "in_front.h"

#include <poll.h>
#include <pthread.h>
#include <semaphore.h>
#include <signal.h>
#include <sys/epoll.h>
#include <sys/select.h>
#include <threads.h>
#include <time.h>
#include <unistd.h>

typedef const struct timespec* Time;
typedef pthread_mutex_t* Mutex;
typedef pthread_rwlock_t* RwLock;
typedef pthread_cond_t* Cond;
typedef struct pollfd* Polled;
typedef struct epoll_event* Events;
typedef const sigset_t* Signals;

/* Condition variables have an older version there. */
#define SECOND "GLIBC_2.3.2"
#define IS_LATER(TIME) (!(TIME) || (TIME)->tv_sec > 0 || (TIME)->tv_nsec > 0)

/* clang-format off */
OROFORGE_WATCH(LOCK, int, pthread_mutex_lock, (Mutex m), (m))
OROFORGE_WATCH(LOCK, int, pthread_mutex_timedlock, (Mutex m, Time t), (m, t))
OROFORGE_WATCH(LOCK, int, pthread_mutex_clocklock, (Mutex m, clockid_t c, Time t), (m, c, t))
OROFORGE_WATCH(LOCK, int, pthread_rwlock_rdlock, (RwLock l), (l))
OROFORGE_WATCH(LOCK, int, pthread_rwlock_wrlock, (RwLock l), (l))
OROFORGE_WATCH(LOCK, int, pthread_rwlock_timedrdlock, (RwLock l, Time t), (l, t))
OROFORGE_WATCH(LOCK, int, pthread_rwlock_timedwrlock, (RwLock l, Time t), (l, t))
OROFORGE_WATCH(LOCK, int, pthread_rwlock_clockrdlock, (RwLock l, clockid_t c, Time t), (l, c, t))
OROFORGE_WATCH(LOCK, int, pthread_rwlock_clockwrlock, (RwLock l, clockid_t c, Time t), (l, c, t))
OROFORGE_WATCH(LOCK, int, pthread_spin_lock, (pthread_spinlock_t* l), (l))
OROFORGE_WATCH(LOCK, int, mtx_lock, (mtx_t* m), (m))
OROFORGE_WATCH(LOCK, int, mtx_timedlock, (mtx_t* m, Time t), (m, t))

OROFORGE_WATCH_VERSION(WAIT, SECOND, int, pthread_cond_wait, (Cond c, Mutex m), (c, m), 1)
OROFORGE_WATCH_VERSION(WAIT, SECOND, int, pthread_cond_timedwait, (Cond c, Mutex m, Time t), (c, m, t), 1)
OROFORGE_WATCH(WAIT, int, pthread_cond_clockwait, (Cond c, Mutex m, clockid_t k, Time t), (c, m, k, t))
OROFORGE_WATCH(WAIT, int, cnd_wait, (cnd_t* c, mtx_t* m), (c, m))
OROFORGE_WATCH(WAIT, int, cnd_timedwait, (cnd_t* c, mtx_t* m, Time t), (c, m, t))
OROFORGE_WATCH(WAIT, int, sem_wait, (sem_t* s), (s))
OROFORGE_WATCH(WAIT, int, sem_timedwait, (sem_t* s, Time t), (s, t))
OROFORGE_WATCH(WAIT, int, sem_clockwait, (sem_t* s, clockid_t c, Time t), (s, c, t))
OROFORGE_WATCH(WAIT, int, pthread_barrier_wait, (pthread_barrier_t* b), (b))
OROFORGE_WATCH(WAIT, int, pthread_join, (pthread_t t, void** result), (t, result))
OROFORGE_WATCH(WAIT, int, pthread_timedjoin_np, (pthread_t t, void** result, Time until), (t, result, until))
OROFORGE_WATCH(WAIT, int, pthread_clockjoin_np, (pthread_t t, void** result, clockid_t c, Time until), (t, result, c, until))
OROFORGE_WATCH(WAIT, int, thrd_join, (thrd_t t, int* result), (t, result))

OROFORGE_WATCH_IF(WAIT, int, nanosleep, (Time t, struct timespec* rest), (t, rest), IS_LATER(t))
OROFORGE_WATCH(WAIT, int, clock_nanosleep, (clockid_t c, int flags, Time t, struct timespec* rest), (c, flags, t, rest))
OROFORGE_WATCH(WAIT, int, thrd_sleep, (Time t, struct timespec* rest), (t, rest))
OROFORGE_WATCH(WAIT, int, usleep, (useconds_t n), (n))
OROFORGE_WATCH(WAIT, unsigned, sleep, (unsigned n), (n))

OROFORGE_WATCH(WAIT, int, pause, (void), ())
OROFORGE_WATCH(WAIT, int, sigsuspend, (Signals s), (s))
OROFORGE_WATCH(WAIT, int, sigwait, (Signals s, int* got), (s, got))
OROFORGE_WATCH(WAIT, int, sigwaitinfo, (Signals s, siginfo_t* got), (s, got))
OROFORGE_WATCH_IF(WAIT, int, sigtimedwait, (Signals s, siginfo_t* got, Time t), (s, got, t), IS_LATER(t))

OROFORGE_WATCH_IF(WAIT, int, poll, (Polled p, nfds_t n, int ms), (p, n, ms), ms != 0)
OROFORGE_WATCH_IF(WAIT, int, ppoll, (Polled p, nfds_t n, Time t, Signals s), (p, n, t, s), IS_LATER(t))
OROFORGE_WATCH_IF(WAIT, int, select, (int n, fd_set* r, fd_set* w, fd_set* e, struct timeval* t), (n, r, w, e, t),
                  !t || t->tv_sec > 0 || t->tv_usec > 0)
OROFORGE_WATCH_IF(WAIT, int, pselect, (int n, fd_set* r, fd_set* w, fd_set* e, Time t, Signals s), (n, r, w, e, t, s), IS_LATER(t))
OROFORGE_WATCH_IF(WAIT, int, epoll_wait, (int fd, Events e, int n, int ms), (fd, e, n, ms), ms != 0)
OROFORGE_WATCH_IF(WAIT, int, epoll_pwait, (int fd, Events e, int n, int ms, Signals s), (fd, e, n, ms, s), ms != 0)
#if __GLIBC_PREREQ(2, 35)
OROFORGE_WATCH_IF(WAIT, int, epoll_pwait2, (int fd, Events e, int n, Time t, Signals s), (fd, e, n, t, s), IS_LATER(t))
#endif

/* Called instead where a package is built with _FORTIFY_SOURCE. */
extern int __poll_chk(Polled, nfds_t, int, size_t);
extern int __ppoll_chk(Polled, nfds_t, Time, Signals, size_t);
OROFORGE_WATCH_IF(WAIT, int, __poll_chk, (Polled p, nfds_t n, int ms, size_t size), (p, n, ms, size), ms != 0)
OROFORGE_WATCH_IF(WAIT, int, __ppoll_chk, (Polled p, nfds_t n, Time t, Signals s, size_t size), (p, n, t, s, size), IS_LATER(t))
/* clang-format on */
