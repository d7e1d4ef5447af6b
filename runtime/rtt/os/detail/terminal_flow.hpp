// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_OS_DETAIL_TERMINAL_FLOW_HPP
#define RTT_OS_DETAIL_TERMINAL_FLOW_HPP

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/syscall.h>
#include <termios.h>
#include <unistd.h>

namespace RTT {
namespace os {
namespace detail {

/** Makes a write to a terminal, in whatever thread, begin again: SIGWINCH has a handler wherever there is a console. */
inline void interruptThreads() noexcept {
    const int folder = open("/proc/self/task", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    alignas(8) char entries[2048];
    for (long size; (size = syscall(SYS_getdents64, folder, entries, sizeof entries)) > 0;) {
        for (long at = 0; at < size;) {
            // struct linux_dirent64: number, offset, size of the entry, type, name
            std::uint16_t length = 0;
            std::memcpy(&length, entries + at + 16, sizeof length);
            const long thread = std::atol(entries + at + 19);
            if (thread > 0) syscall(SYS_tgkill, getpid(), thread, SIGWINCH);
            at += length;
        }
    }
    close(folder);
}

/**
 * Nobody waits for a terminal any more, perhaps with a mutex that others want: one that was stopped by Ctrl-S writes again, and
 * what goes to one that takes nothing all the same, since nobody reads at its other end, is thrown away from now on. For
 * handlers of signals that end the process.
 */
inline void letTerminalsWrite() noexcept {
    constexpr int kPatience = 200;  // milliseconds, for a terminal that is only slow
    const int error = errno;
    // Whoever asks from the background would be stopped.
    sigset_t only, masked;
    sigemptyset(&only);
    sigaddset(&only, SIGTTOU);
    pthread_sigmask(SIG_BLOCK, &only, &masked);
    bool stuck = false;
    for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
        if (isatty(descriptor) == 0) continue;
        // Linux starts what Ctrl-S has stopped only if it was stopped in this way as well.
        (void)tcflow(descriptor, TCOOFF);
        (void)tcflow(descriptor, TCOON);
        pollfd writable = {descriptor, POLLOUT, 0};
        if (poll(&writable, 1, kPatience) != 0) continue;
        const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (nowhere < 0) continue;
        stuck = dup2(nowhere, descriptor) >= 0 || stuck;
        close(nowhere);
    }
    if (stuck) interruptThreads();
    pthread_sigmask(SIG_SETMASK, &masked, nullptr);
    errno = error;
}

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
