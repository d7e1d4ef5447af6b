// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_TERMINAL_FLOW_HPP
#define ORO_OS_TERMINAL_FLOW_HPP

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <initializer_list>

#include <fcntl.h>
#include <poll.h>
#include <sys/syscall.h>
#include <termios.h>
#include <unistd.h>

namespace RTT {
namespace os {
namespace detail {

/** Restarts writes to a terminal in all threads, by SIGWINCH, for which a program with a console has a handler. */
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
 * Ends all waiting for terminals, because a thread that waits may hold a mutex that others need. A terminal stopped by
 * Ctrl-S goes on. Output to one that still takes nothing, because nobody reads at its other end, is dropped from now
 * on. For handlers of signals that end the process.
 */
inline void letTerminalsWrite() noexcept {
    constexpr int kPatience = 200;  // milliseconds, for a terminal that is only slow
    const int error = errno;
    // A process in the background would be stopped for this call.
    sigset_t only, masked;
    sigemptyset(&only);
    sigaddset(&only, SIGTTOU);
    pthread_sigmask(SIG_BLOCK, &only, &masked);
    bool stuck = false;
    for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
        if (isatty(descriptor) == 0) continue;
        // Linux restarts a terminal stopped by Ctrl-S only if this call stopped it, too.
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
