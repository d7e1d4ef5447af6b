/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
/*
 * System calls that may block. What is done with a descriptor that is open for not blocking counts for nothing, unless it is
 * that of a file, for which that has no effect.
 */
#include "in_front.h"

#include <dirent.h>
#include <fcntl.h>
#include <mqueue.h>
#include <pthread.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/msg.h>
#include <semaphore.h>
#include <sys/resource.h>
#include <sys/sem.h>
#include <sys/sendfile.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/uio.h>
#include <sys/vfs.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

int oroforge_rt_may_block(int fd) {
    const int flags = fcntl(fd, F_GETFL);
    if (flags < 0) return 0; /* not open: the call fails at once */
    if (!(flags & O_NONBLOCK)) return 1;
    struct stat status;
    return fstat(fd, &status) == 0 && (S_ISREG(status.st_mode) || S_ISBLK(status.st_mode) || S_ISDIR(status.st_mode));
}
#define SOCKET_MAY_BLOCK (!(flags & MSG_DONTWAIT) && oroforge_rt_may_block(s))
#define QUEUE_MAY_BLOCK queue_may_block(q)

static int queue_may_block(mqd_t q) {
    struct mq_attr attributes;
    return mq_getattr(q, &attributes) == 0 && !(attributes.mq_flags & O_NONBLOCK);
}

typedef const struct iovec* Parts;
typedef const struct sockaddr* ToAddress;
typedef struct sockaddr* Address;
typedef const struct timespec* Time;

/* clang-format off */
#define WATCH_FD(RESULT, NAME, PARAMETERS, ARGUMENTS) OROFORGE_WATCH_IF(SYSTEM_CALL, RESULT, NAME, PARAMETERS, ARGUMENTS, oroforge_rt_may_block(fd))
WATCH_FD(ssize_t, read, (int fd, void* to, size_t size), (fd, to, size))
WATCH_FD(ssize_t, write, (int fd, const void* from, size_t size), (fd, from, size))
WATCH_FD(ssize_t, readv, (int fd, Parts parts, int n), (fd, parts, n))
WATCH_FD(ssize_t, writev, (int fd, Parts parts, int n), (fd, parts, n))
WATCH_FD(ssize_t, pread, (int fd, void* to, size_t size, off_t at), (fd, to, size, at))
WATCH_FD(ssize_t, pwrite, (int fd, const void* from, size_t size, off_t at), (fd, from, size, at))
WATCH_FD(ssize_t, pread64, (int fd, void* to, size_t size, off64_t at), (fd, to, size, at))
WATCH_FD(ssize_t, pwrite64, (int fd, const void* from, size_t size, off64_t at), (fd, from, size, at))
WATCH_FD(ssize_t, sendfile, (int out, int fd, off_t* at, size_t size), (out, fd, at, size))
WATCH_FD(int, fsync, (int fd), (fd))
WATCH_FD(int, fdatasync, (int fd), (fd))
WATCH_FD(int, ftruncate, (int fd, off_t size), (fd, size))
WATCH_FD(int, close, (int fd), (fd))
WATCH_FD(ssize_t, preadv, (int fd, Parts parts, int n, off_t at), (fd, parts, n, at))
WATCH_FD(ssize_t, pwritev, (int fd, Parts parts, int n, off_t at), (fd, parts, n, at))
WATCH_FD(int, syncfs, (int fd), (fd))
WATCH_FD(ssize_t, copy_file_range, (int fd, off64_t* from, int out, off64_t* to, size_t size, unsigned flags), (fd, from, out, to, size, flags))
WATCH_FD(ssize_t, splice, (int fd, off64_t* from, int out, off64_t* to, size_t size, unsigned flags), (fd, from, out, to, size, flags))
/* Whatever the line was opened with: it waits until all is sent. */
OROFORGE_WATCH(SYSTEM_CALL, int, tcdrain, (int fd), (fd))
OROFORGE_WATCH(SYSTEM_CALL, int, tcsendbreak, (int fd, int duration), (fd, duration))
OROFORGE_WATCH_IF(SYSTEM_CALL, int, tcsetattr, (int fd, int when, const struct termios* to), (fd, when, to), when != TCSANOW)
WATCH_FD(int, fallocate, (int fd, int how, off_t at, off_t size), (fd, how, at, size))
WATCH_FD(int, posix_fallocate, (int fd, off_t at, off_t size), (fd, at, size))
OROFORGE_WATCH_IF(SYSTEM_CALL, int, flock, (int fd, int what), (fd, what), !(what & (LOCK_NB | LOCK_UN)))
OROFORGE_WATCH_IF(SYSTEM_CALL, int, lockf, (int fd, int what, off_t size), (fd, what, size), what == F_LOCK)

#define WATCH_SOCKET(NAME, PARAMETERS, ARGUMENTS) OROFORGE_WATCH_IF(SYSTEM_CALL, ssize_t, NAME, PARAMETERS, ARGUMENTS, SOCKET_MAY_BLOCK)
WATCH_SOCKET(send, (int s, const void* from, size_t size, int flags), (s, from, size, flags))
WATCH_SOCKET(sendto, (int s, const void* from, size_t size, int flags, ToAddress a, socklen_t n), (s, from, size, flags, a, n))
WATCH_SOCKET(sendmsg, (int s, const struct msghdr* message, int flags), (s, message, flags))
WATCH_SOCKET(recv, (int s, void* to, size_t size, int flags), (s, to, size, flags))
WATCH_SOCKET(recvfrom, (int s, void* to, size_t size, int flags, Address a, socklen_t* n), (s, to, size, flags, a, n))
WATCH_SOCKET(recvmsg, (int s, struct msghdr* message, int flags), (s, message, flags))
OROFORGE_WATCH_IF(SYSTEM_CALL, int, sendmmsg, (int s, struct mmsghdr* m, unsigned n, int flags), (s, m, n, flags), SOCKET_MAY_BLOCK)
OROFORGE_WATCH_IF(SYSTEM_CALL, int, recvmmsg, (int s, struct mmsghdr* m, unsigned n, int flags, struct timespec* t), (s, m, n, flags, t), SOCKET_MAY_BLOCK)
WATCH_FD(int, accept, (int fd, Address a, socklen_t* n), (fd, a, n))
WATCH_FD(int, accept4, (int fd, Address a, socklen_t* n, int flags), (fd, a, n, flags))
WATCH_FD(int, connect, (int fd, ToAddress a, socklen_t n), (fd, a, n))

OROFORGE_WATCH_IF(SYSTEM_CALL, int, mq_send, (mqd_t q, const char* from, size_t size, unsigned priority), (q, from, size, priority), QUEUE_MAY_BLOCK)
OROFORGE_WATCH_IF(SYSTEM_CALL, ssize_t, mq_receive, (mqd_t q, char* to, size_t size, unsigned* priority), (q, to, size, priority), QUEUE_MAY_BLOCK)
OROFORGE_WATCH_IF(SYSTEM_CALL, int, mq_timedsend, (mqd_t q, const char* from, size_t size, unsigned priority, Time t), (q, from, size, priority, t), QUEUE_MAY_BLOCK)
OROFORGE_WATCH_IF(SYSTEM_CALL, ssize_t, mq_timedreceive, (mqd_t q, char* to, size_t size, unsigned* priority, Time t), (q, to, size, priority, t), QUEUE_MAY_BLOCK)

OROFORGE_WATCH_IF(SYSTEM_CALL, int, msgsnd, (int q, const void* from, size_t size, int flags), (q, from, size, flags), !(flags & IPC_NOWAIT))
OROFORGE_WATCH_IF(SYSTEM_CALL, ssize_t, msgrcv, (int q, void* to, size_t size, long type, int flags), (q, to, size, type, flags), !(flags & IPC_NOWAIT))
OROFORGE_WATCH(SYSTEM_CALL, int, semop, (int set, struct sembuf* what, size_t n), (set, what, n))
OROFORGE_WATCH(SYSTEM_CALL, int, semtimedop, (int set, struct sembuf* what, size_t n, Time t), (set, what, n, t))

OROFORGE_WATCH(SYSTEM_CALL, int, creat, (const char* path, mode_t mode), (path, mode))
OROFORGE_WATCH(SYSTEM_CALL, int, stat, (const char* path, struct stat* to), (path, to))
OROFORGE_WATCH(SYSTEM_CALL, int, lstat, (const char* path, struct stat* to), (path, to))
OROFORGE_WATCH(SYSTEM_CALL, int, access, (const char* path, int what), (path, what))
OROFORGE_WATCH(SYSTEM_CALL, int, fstatat, (int at, const char* path, struct stat* to, int flags), (at, path, to, flags))
OROFORGE_WATCH(SYSTEM_CALL, int, truncate, (const char* path, off_t size), (path, size))
OROFORGE_WATCH(SYSTEM_CALL, ssize_t, readlink, (const char* path, char* to, size_t size), (path, to, size))
OROFORGE_WATCH_VERSION(SYSTEM_CALL, "GLIBC_2.3", char*, realpath, (const char* path, char* to), (path, to), 1)
OROFORGE_WATCH(SYSTEM_CALL, int, statvfs, (const char* path, struct statvfs* to), (path, to))
OROFORGE_WATCH(SYSTEM_CALL, int, statfs, (const char* path, struct statfs* to), (path, to))
OROFORGE_WATCH(SYSTEM_CALL, int, statx, (int at, const char* path, int flags, unsigned mask, struct statx* to), (at, path, flags, mask, to))
OROFORGE_WATCH(SYSTEM_CALL, int, chmod, (const char* path, mode_t mode), (path, mode))
OROFORGE_WATCH(SYSTEM_CALL, int, link, (const char* path, const char* to), (path, to))
OROFORGE_WATCH(SYSTEM_CALL, int, symlink, (const char* path, const char* to), (path, to))
OROFORGE_WATCH(SYSTEM_CALL, int, mkstemp, (char* path), (path))
OROFORGE_WATCH(SYSTEM_CALL, int, mkostemp, (char* path, int flags), (path, flags))
OROFORGE_WATCH(SYSTEM_CALL, char*, mkdtemp, (char* path), (path))
OROFORGE_WATCH(SYSTEM_CALL, int, chdir, (const char* path), (path))
OROFORGE_WATCH(SYSTEM_CALL, int, unlink, (const char* path), (path))
OROFORGE_WATCH(SYSTEM_CALL, int, unlinkat, (int at, const char* path, int flags), (at, path, flags))
OROFORGE_WATCH(SYSTEM_CALL, int, remove, (const char* path), (path))
OROFORGE_WATCH(SYSTEM_CALL, int, rename, (const char* path, const char* to), (path, to))
OROFORGE_WATCH(SYSTEM_CALL, int, mkdir, (const char* path, mode_t mode), (path, mode))
OROFORGE_WATCH(SYSTEM_CALL, int, rmdir, (const char* path), (path))
OROFORGE_WATCH(SYSTEM_CALL, DIR*, opendir, (const char* path), (path))
OROFORGE_WATCH(SYSTEM_CALL, struct dirent*, readdir, (DIR* d), (d))
OROFORGE_WATCH(SYSTEM_CALL, int, msync, (void* at, size_t size, int flags), (at, size, flags))
OROFORGE_WATCH(SYSTEM_CALL, int, shm_open, (const char* name, int flags, mode_t mode), (name, flags, mode))
OROFORGE_WATCH(SYSTEM_CALL, int, shm_unlink, (const char* name), (name))
OROFORGE_WATCH(SYSTEM_CALL, int, mq_unlink, (const char* name), (name))

OROFORGE_WATCH(SYSTEM_CALL, pid_t, fork, (void), ())
OROFORGE_WATCH_IF(SYSTEM_CALL, pid_t, waitpid, (pid_t p, int* status, int how), (p, status, how), !(how & WNOHANG))
OROFORGE_WATCH(SYSTEM_CALL, pid_t, wait, (int* status), (status))
OROFORGE_WATCH_IF(SYSTEM_CALL, pid_t, wait4, (pid_t p, int* status, int how, struct rusage* used), (p, status, how, used), !(how & WNOHANG))
OROFORGE_WATCH_IF(SYSTEM_CALL, int, waitid, (idtype_t kind, id_t id, siginfo_t* got, int how), (kind, id, got, how), !(how & WNOHANG))
OROFORGE_WATCH(SYSTEM_CALL, int, system, (const char* command), (command))
OROFORGE_WATCH_VERSION(SYSTEM_CALL, "GLIBC_2.15", int, posix_spawn,
    (pid_t* p, const char* path, const posix_spawn_file_actions_t* f, const posix_spawnattr_t* a, char* const* words, char* const* environment), (p, path, f, a, words, environment), 1)
OROFORGE_WATCH_VERSION(SYSTEM_CALL, "GLIBC_2.15", int, posix_spawnp,
    (pid_t* p, const char* path, const posix_spawn_file_actions_t* f, const posix_spawnattr_t* a, char* const* words, char* const* environment), (p, path, f, a, words, environment), 1)
OROFORGE_WATCH(THREAD, int, pthread_create, (pthread_t* t, const pthread_attr_t* a, void* (*entry)(void*), void* argument), (t, a, entry, argument))

/* Called instead where a package is built with _FILE_OFFSET_BITS=64, and by the C++ library. */
WATCH_FD(ssize_t, sendfile64, (int out, int fd, off64_t* at, size_t size), (out, fd, at, size))
WATCH_FD(ssize_t, preadv64, (int fd, Parts parts, int n, off64_t at), (fd, parts, n, at))
WATCH_FD(ssize_t, pwritev64, (int fd, Parts parts, int n, off64_t at), (fd, parts, n, at))
WATCH_FD(int, ftruncate64, (int fd, off64_t size), (fd, size))
WATCH_FD(int, fallocate64, (int fd, int how, off64_t at, off64_t size), (fd, how, at, size))
WATCH_FD(int, posix_fallocate64, (int fd, off64_t at, off64_t size), (fd, at, size))
OROFORGE_WATCH_IF(SYSTEM_CALL, int, lockf64, (int fd, int what, off64_t size), (fd, what, size), what == F_LOCK)
OROFORGE_WATCH(SYSTEM_CALL, int, statvfs64, (const char* path, struct statvfs64* to), (path, to))
OROFORGE_WATCH(SYSTEM_CALL, int, statfs64, (const char* path, struct statfs64* to), (path, to))
OROFORGE_WATCH(SYSTEM_CALL, int, mkstemp64, (char* path), (path))
OROFORGE_WATCH(SYSTEM_CALL, int, mkostemp64, (char* path, int flags), (path, flags))
OROFORGE_WATCH(SYSTEM_CALL, int, creat64, (const char* path, mode_t mode), (path, mode))
OROFORGE_WATCH(SYSTEM_CALL, int, truncate64, (const char* path, off64_t size), (path, size))
OROFORGE_WATCH(SYSTEM_CALL, int, stat64, (const char* path, struct stat64* to), (path, to))
OROFORGE_WATCH(SYSTEM_CALL, int, lstat64, (const char* path, struct stat64* to), (path, to))
OROFORGE_WATCH(SYSTEM_CALL, int, fstatat64, (int at, const char* path, struct stat64* to, int flags), (at, path, to, flags))
OROFORGE_WATCH(SYSTEM_CALL, struct dirent64*, readdir64, (DIR* d), (d))

/* Called instead where a package is built with _FORTIFY_SOURCE. */
extern ssize_t __read_chk(int, void*, size_t, size_t);
extern ssize_t __pread_chk(int, void*, size_t, off_t, size_t);
extern ssize_t __pread64_chk(int, void*, size_t, off64_t, size_t);
extern ssize_t __recv_chk(int, void*, size_t, size_t, int);
extern ssize_t __recvfrom_chk(int, void*, size_t, size_t, int, Address, socklen_t*);
extern char* __realpath_chk(const char*, char*, size_t);
extern int __open_2(const char*, int);
extern int __open64_2(const char*, int);
extern int __openat_2(int, const char*, int);
extern int __openat64_2(int, const char*, int);
WATCH_FD(ssize_t, __read_chk, (int fd, void* to, size_t size, size_t room), (fd, to, size, room))
WATCH_FD(ssize_t, __pread_chk, (int fd, void* to, size_t size, off_t at, size_t room), (fd, to, size, at, room))
WATCH_FD(ssize_t, __pread64_chk, (int fd, void* to, size_t size, off64_t at, size_t room), (fd, to, size, at, room))
WATCH_SOCKET(__recv_chk, (int s, void* to, size_t size, size_t room, int flags), (s, to, size, room, flags))
WATCH_SOCKET(__recvfrom_chk, (int s, void* to, size_t size, size_t room, int flags, Address a, socklen_t* n), (s, to, size, room, flags, a, n))
OROFORGE_WATCH(SYSTEM_CALL, char*, __realpath_chk, (const char* path, char* to, size_t room), (path, to, room))
OROFORGE_WATCH_IF(SYSTEM_CALL, int, __open_2, (const char* path, int flags), (path, flags), OROFORGE_NOTE_PATH(path, "__open_2"))
OROFORGE_WATCH_IF(SYSTEM_CALL, int, __open64_2, (const char* path, int flags), (path, flags), OROFORGE_NOTE_PATH(path, "__open64_2"))
OROFORGE_WATCH_IF(SYSTEM_CALL, int, __openat_2, (int at, const char* path, int flags), (at, path, flags), OROFORGE_NOTE_PATH(path, "__openat_2"))
OROFORGE_WATCH_IF(SYSTEM_CALL, int, __openat64_2, (int at, const char* path, int flags), (at, path, flags), OROFORGE_NOTE_PATH(path, "__openat64_2"))
/* clang-format on */

OROFORGE_IN_FRONT void sync(void) {
    OROFORGE_COUNT(SYSTEM_CALL, "sync");
    OROFORGE_NEXT_OF(sync, 0)();
    OROFORGE_COUNTED();
}

/* The third argument, or the fourth, is there only if a file may be made. */
#define MODE_AFTER(LAST)                   \
    mode_t mode = 0;                       \
    if (flags & (O_CREAT | __O_TMPFILE)) { \
        va_list list;                      \
        va_start(list, LAST);              \
        mode = (mode_t)va_arg(list, int);  \
        va_end(list);                      \
    }
#define OPEN(NAME)                                                       \
    OROFORGE_IN_FRONT int NAME(const char* path, int flags, ...) {       \
        MODE_AFTER(flags)                                                \
        if (oroforge_rt_watching()) (void)OROFORGE_NOTE_PATH(path, #NAME); \
        OROFORGE_COUNT(SYSTEM_CALL, #NAME);                              \
        const int result = OROFORGE_NEXT_OF(NAME, 0)(path, flags, mode); \
        OROFORGE_COUNTED();                                              \
        return result;                                                   \
    }
#define OPEN_AT(NAME)                                                        \
    OROFORGE_IN_FRONT int NAME(int at, const char* path, int flags, ...) {   \
        MODE_AFTER(flags)                                                    \
        if (oroforge_rt_watching()) (void)OROFORGE_NOTE_PATH(path, #NAME);   \
        OROFORGE_COUNT(SYSTEM_CALL, #NAME);                                  \
        const int result = OROFORGE_NEXT_OF(NAME, 0)(at, path, flags, mode); \
        OROFORGE_COUNTED();                                                  \
        return result;                                                       \
    }
OPEN(open)
OPEN(open64)
OPEN_AT(openat)
OPEN_AT(openat64)

OROFORGE_IN_FRONT mqd_t mq_open(const char* name, int flags, ...) {
    va_list list;
    va_start(list, flags);
    const mode_t mode = flags & O_CREAT ? (mode_t)va_arg(list, int) : 0;
    struct mq_attr* const attributes = flags & O_CREAT ? va_arg(list, struct mq_attr*) : 0;
    va_end(list);
    OROFORGE_COUNT(SYSTEM_CALL, "mq_open");
    const mqd_t result = OROFORGE_NEXT_OF(mq_open, 0)(name, flags, mode, attributes);
    OROFORGE_COUNTED();
    return result;
}

OROFORGE_IN_FRONT sem_t* sem_open(const char* name, int flags, ...) {
    va_list list;
    va_start(list, flags);
    const mode_t mode = flags & O_CREAT ? (mode_t)va_arg(list, int) : 0;
    const unsigned value = flags & O_CREAT ? va_arg(list, unsigned) : 0;
    va_end(list);
    OROFORGE_COUNT(SYSTEM_CALL, "sem_open");
    sem_t* const result = OROFORGE_NEXT_OF(sem_open, 0)(name, flags, mode, value);
    OROFORGE_COUNTED();
    return result;
}

/* Most of what it does is done at once; a lock is waited for. */
#define FCNTL(NAME)                                                                     \
    OROFORGE_IN_FRONT int NAME(int fd, int what, ...) {                                 \
        va_list list;                                                                   \
        va_start(list, what);                                                           \
        void* const argument = va_arg(list, void*);                                     \
        va_end(list);                                                                   \
        const __typeof__(&NAME) next_ = OROFORGE_NEXT_OF(NAME, 0);                      \
        if (what != F_SETLKW && what != F_OFD_SETLKW) return next_(fd, what, argument); \
        OROFORGE_COUNT(SYSTEM_CALL, #NAME);                                             \
        const int result = next_(fd, what, argument);                                   \
        OROFORGE_COUNTED();                                                             \
        return result;                                                                  \
    }
FCNTL(fcntl)
FCNTL(fcntl64)

OROFORGE_IN_FRONT int ioctl(int fd, unsigned long request, ...) {
    va_list list;
    va_start(list, request);
    void* const argument = va_arg(list, void*);
    va_end(list);
    const __typeof__(&ioctl) next_ = OROFORGE_NEXT_OF(ioctl, 0);
    if (!oroforge_rt_watching() || !oroforge_rt_may_block(fd)) return next_(fd, request, argument);
    OROFORGE_COUNT(SYSTEM_CALL, "ioctl");
    const int result = next_(fd, request, argument);
    OROFORGE_COUNTED();
    return result;
}
