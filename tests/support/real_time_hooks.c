/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
/*
 * Functions that stand in front of libc's in a program that links them: the dynamic linker finds those of the program
 * first, for libraries too. C, because libc declares its own with exception specifications that differ.
 */
#include "real_time_hooks.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)

int oroforge_real_time_hooks_present(void) { return 0; }

#else

#include <dlfcn.h>
#include <errno.h>
#include <linux/futex.h>
#include <pthread.h>
#include <semaphore.h>
#include <stdarg.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

int oroforge_real_time_hooks_present(void) { return 1; }

enum { ALLOCATION = 1, RELEASE = 2, LOCK = 4, WAIT = 8 };

/* libc's heap under the names that remain when the others are taken. */
extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);
extern void __libc_free(void*);

void* malloc(size_t size) {
    oroforge_real_time_note(ALLOCATION, "malloc", __builtin_return_address(0));
    return __libc_malloc(size);
}
void* calloc(size_t count, size_t size) {
    oroforge_real_time_note(ALLOCATION, "calloc", __builtin_return_address(0));
    return __libc_calloc(count, size);
}
void* realloc(void* block, size_t size) {
    oroforge_real_time_note(ALLOCATION, "realloc", __builtin_return_address(0));
    return __libc_realloc(block, size);
}
void* memalign(size_t alignment, size_t size) {
    oroforge_real_time_note(ALLOCATION, "memalign", __builtin_return_address(0));
    return __libc_memalign(alignment, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
    oroforge_real_time_note(ALLOCATION, "aligned_alloc", __builtin_return_address(0));
    return __libc_memalign(alignment, size);
}
int posix_memalign(void** block, size_t alignment, size_t size) {
    oroforge_real_time_note(ALLOCATION, "posix_memalign", __builtin_return_address(0));
    void* const got = __libc_memalign(alignment, size);
    if (!got) return ENOMEM;
    *block = got;
    return 0;
}
void free(void* block) {
    if (block) oroforge_real_time_note(RELEASE, "free", __builtin_return_address(0));
    __libc_free(block);
}

/* Condition variables have older versions, which dlsym() would give. */
static void* next(const char* name, const char* version) {
    void* const found = version ? dlvsym(RTLD_NEXT, name, version) : dlsym(RTLD_NEXT, name);
    if (!found) abort();
    return found;
}

#define IN_FRONT_OF(KIND, VERSION, RESULT, NAME, PARAMETERS, ARGUMENTS)      \
    RESULT NAME PARAMETERS {                                                 \
        static RESULT(*real) PARAMETERS;                                     \
        RESULT(*call) PARAMETERS = __atomic_load_n(&real, __ATOMIC_RELAXED); \
        if (!call) {                                                         \
            call = (RESULT(*) PARAMETERS)next(#NAME, VERSION);               \
            __atomic_store_n(&real, call, __ATOMIC_RELAXED);                 \
        }                                                                    \
        oroforge_real_time_note(KIND, #NAME, __builtin_return_address(0));   \
        return call ARGUMENTS;                                               \
    }

typedef const struct timespec* Time;
typedef pthread_mutex_t* Mutex;
typedef pthread_rwlock_t* RwLock;
typedef pthread_cond_t* Cond;

/* clang-format off */
IN_FRONT_OF(LOCK, 0, int, pthread_mutex_lock, (Mutex m), (m))
IN_FRONT_OF(LOCK, 0, int, pthread_mutex_trylock, (Mutex m), (m))
IN_FRONT_OF(LOCK, 0, int, pthread_mutex_timedlock, (Mutex m, Time t), (m, t))
IN_FRONT_OF(LOCK, 0, int, pthread_mutex_clocklock, (Mutex m, clockid_t c, Time t), (m, c, t))
IN_FRONT_OF(LOCK, 0, int, pthread_rwlock_rdlock, (RwLock l), (l))
IN_FRONT_OF(LOCK, 0, int, pthread_rwlock_wrlock, (RwLock l), (l))
IN_FRONT_OF(LOCK, 0, int, pthread_rwlock_tryrdlock, (RwLock l), (l))
IN_FRONT_OF(LOCK, 0, int, pthread_rwlock_trywrlock, (RwLock l), (l))
IN_FRONT_OF(LOCK, 0, int, pthread_rwlock_timedrdlock, (RwLock l, Time t), (l, t))
IN_FRONT_OF(LOCK, 0, int, pthread_rwlock_timedwrlock, (RwLock l, Time t), (l, t))
IN_FRONT_OF(LOCK, 0, int, pthread_spin_lock, (pthread_spinlock_t* l), (l))
IN_FRONT_OF(WAIT, "GLIBC_2.3.2", int, pthread_cond_wait, (Cond c, Mutex m), (c, m))
IN_FRONT_OF(WAIT, "GLIBC_2.3.2", int, pthread_cond_timedwait, (Cond c, Mutex m, Time t), (c, m, t))
IN_FRONT_OF(WAIT, 0, int, pthread_cond_clockwait, (Cond c, Mutex m, clockid_t k, Time t), (c, m, k, t))
IN_FRONT_OF(WAIT, 0, int, sem_wait, (sem_t* s), (s))
IN_FRONT_OF(WAIT, 0, int, sem_timedwait, (sem_t* s, Time t), (s, t))
IN_FRONT_OF(WAIT, 0, int, sem_clockwait, (sem_t* s, clockid_t c, Time t), (s, c, t))
IN_FRONT_OF(WAIT, 0, int, pthread_join, (pthread_t t, void** result), (t, result))
IN_FRONT_OF(WAIT, 0, int, nanosleep, (Time t, struct timespec* rest), (t, rest))
IN_FRONT_OF(WAIT, 0, int, clock_nanosleep, (clockid_t c, int flags, Time t, struct timespec* rest), (c, flags, t, rest))
IN_FRONT_OF(WAIT, 0, int, usleep, (useconds_t n), (n))
/* clang-format on */

static int waits(long operation) {
    switch (operation & FUTEX_CMD_MASK) {
        case FUTEX_WAIT:
        case FUTEX_WAIT_BITSET:
        case FUTEX_LOCK_PI:
        case FUTEX_WAIT_REQUEUE_PI: return 1;
        default: return 0;
    }
}

long syscall(long number, ...) {
    static long (*real)(long, ...);
    long (*call)(long, ...) = __atomic_load_n(&real, __ATOMIC_RELAXED);
    if (!call) {
        call = (long (*)(long, ...))next("syscall", 0);
        __atomic_store_n(&real, call, __ATOMIC_RELAXED);
    }
    /* As libc does: six are taken, however many were given. */
    va_list list;
    va_start(list, number);
    long a[6];
    for (int i = 0; i < 6; ++i) a[i] = va_arg(list, long);
    va_end(list);
    if (number == SYS_futex && waits(a[1])) oroforge_real_time_note(WAIT, "futex", __builtin_return_address(0));
    return call(number, a[0], a[1], a[2], a[3], a[4], a[5]);
}

#endif
