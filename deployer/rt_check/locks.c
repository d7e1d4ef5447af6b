/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
/*
 * Locks, and what waits for another thread, a time or a signal. A lock counts whether or not somebody has it just then: in
 * another cycle somebody will. What only tries counts for nothing, nor does a wait that gives up at once.
 */
#include "in_front.h"

#include <linux/futex.h>
#include <poll.h>
#include <pthread.h>
#include <semaphore.h>
#include <signal.h>
#include <stdarg.h>
#include <sys/epoll.h>
#include <sys/select.h>
#include <sys/syscall.h>
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

/* Called instead where a package is built with _FORTIFY_SOURCE. */
extern int __poll_chk(Polled, nfds_t, int, size_t);
extern int __ppoll_chk(Polled, nfds_t, Time, Signals, size_t);
OROFORGE_WATCH_IF(WAIT, int, __poll_chk, (Polled p, nfds_t n, int ms, size_t size), (p, n, ms, size), ms != 0)
OROFORGE_WATCH_IF(WAIT, int, __ppoll_chk, (Polled p, nfds_t n, Time t, Signals s, size_t size), (p, n, t, s, size), IS_LATER(t))
/* clang-format on */

static int waits(long number, long operation) {
    if (number != SYS_futex) return 0;
    switch (operation & FUTEX_CMD_MASK) {
        case FUTEX_WAIT:
        case FUTEX_WAIT_BITSET:
        case FUTEX_LOCK_PI:
        case FUTEX_WAIT_REQUEUE_PI: return 1;
        default: return 0;
    }
}

static int is_input_or_output(long number) {
    static const long numbers[] = {SYS_read,   SYS_write,   SYS_readv, SYS_writev, SYS_openat,  SYS_sendmsg,
                                   SYS_sendto, SYS_recvmsg, SYS_fsync, SYS_ioctl,  SYS_recvfrom};
    for (unsigned i = 0; i != sizeof numbers / sizeof *numbers; ++i)
        if (numbers[i] == number) return 1;
    return 0;
}

/* The runtime itself waits by futex, and so does the C++ library (std::atomic::wait()). */
OROFORGE_IN_FRONT long syscall(long number, ...) {
    /* As libc does: six are taken, however many were given. */
    va_list list;
    va_start(list, number);
    long a[6];
    for (int i = 0; i < 6; ++i) a[i] = va_arg(list, long);
    va_end(list);
    if (oroforge_rt_watching()) {
        if (waits(number, a[1])) oroforge_rt_note(OROFORGE_RT_WAIT, "futex", __builtin_return_address(0));
        if (is_input_or_output(number))
            oroforge_rt_note(OROFORGE_RT_SYSTEM_CALL, "syscall", __builtin_return_address(0));
    }
    return OROFORGE_NEXT_OF(syscall, 0)(number, a[0], a[1], a[2], a[3], a[4], a[5]);
}
