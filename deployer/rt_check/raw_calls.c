/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
/* syscall(): the runtime itself waits by futex in that way, and so does the C++ library (std::atomic::wait()). */
#include "in_front.h"

#include <linux/futex.h>
#include <stdarg.h>
#include <sys/syscall.h>
#include <unistd.h>

static int is_one_of(long number, const long* numbers, unsigned count) {
    for (unsigned i = 0; i != count; ++i)
        if (numbers[i] == number) return 1;
    return 0;
}
#define IS_ONE_OF(NUMBER, NUMBERS) is_one_of(NUMBER, NUMBERS, sizeof NUMBERS / sizeof *NUMBERS)

static int waits_by_futex(long number, long operation) {
    if (number == SYS_futex_waitv) return 1;
    if (number != SYS_futex) return 0;
    switch (operation & FUTEX_CMD_MASK) {
        case FUTEX_WAIT:
        case FUTEX_WAIT_BITSET:
        case FUTEX_LOCK_PI:
        case FUTEX_LOCK_PI2:
        case FUTEX_WAIT_REQUEUE_PI: return 1;
        default: return 0;
    }
}

static int waits(long number) {
    static const long numbers[] = {SYS_nanosleep,   SYS_clock_nanosleep, SYS_ppoll,        SYS_pselect6,
                                   SYS_epoll_pwait, SYS_rt_sigtimedwait, SYS_rt_sigsuspend};
    return IS_ONE_OF(number, numbers);
}

/** Whose first argument is a descriptor. */
static int uses_descriptor(long number) {
    static const long numbers[] = {SYS_read,     SYS_write,   SYS_readv,  SYS_writev,  SYS_pread64,
                                   SYS_pwrite64, SYS_sendmsg, SYS_sendto, SYS_recvmsg, SYS_recvfrom,
                                   SYS_accept4,  SYS_connect, SYS_fsync,  SYS_ioctl,   SYS_fdatasync};
    return IS_ONE_OF(number, numbers);
}

static int may_block(long number, long first) {
    static const long others[] = {SYS_openat, SYS_wait4, SYS_waitid, SYS_clone, SYS_execve, SYS_sync};
    return uses_descriptor(number) ? oroforge_rt_may_block((int)first) : IS_ONE_OF(number, others);
}

OROFORGE_IN_FRONT long syscall(long number, ...) {
    /* As libc does: six are taken, however many were given. */
    va_list list;
    va_start(list, number);
    long a[6];
    for (int i = 0; i < 6; ++i) a[i] = va_arg(list, long);
    va_end(list);
    if (oroforge_rt_watching()) {
        const void* const caller = __builtin_return_address(0);
        if (waits_by_futex(number, a[1]))
            oroforge_rt_note(OROFORGE_RT_WAIT, "futex", caller);
        else if (waits(number))
            oroforge_rt_note(OROFORGE_RT_WAIT, "syscall", caller);
        else if (may_block(number, a[0]))
            oroforge_rt_note(OROFORGE_RT_SYSTEM_CALL, "syscall", caller);
        else if (number == SYS_mmap || number == SYS_mremap || number == SYS_brk)
            oroforge_rt_note(OROFORGE_RT_ALLOCATION, "syscall", caller);
        else if (number == SYS_getrandom)
            oroforge_rt_note(OROFORGE_RT_RANDOM, "syscall", caller);
    }
    return OROFORGE_NEXT_OF(syscall, 0)(number, a[0], a[1], a[2], a[3], a[4], a[5]);
}
