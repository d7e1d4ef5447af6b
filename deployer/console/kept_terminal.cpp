// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The handlers do only what is safe in any thread at any point, such as tcsetattr().
#include "kept_terminal.hpp"

#include <cerrno>
#include <cstdlib>

#include <termios.h>
#include <unistd.h>

namespace OCL::console {
namespace {

termios original;
volatile sig_atomic_t kept = 0;   // `original` has the previous mode
pid_t owner = -1;                 // a child that ends or crashes must not restore the terminal of its parent
volatile sig_atomic_t paste = 0;  // the terminal marks pasted text
// The previous actions, by signal number.
struct sigaction before[NSIG];

void onStop(int signal, siginfo_t*, void*);

/** True for a signal that is repeated when its instruction is. */
bool isFault(int signal) { return signal == SIGSEGV || signal == SIGBUS || signal == SIGFPE || signal == SIGILL; }

bool isHandler(const struct sigaction& action, void (*handler)(int, siginfo_t*, void*)) {
    return (action.sa_flags & SA_SIGINFO) && action.sa_sigaction == handler;
}

void set(const termios& mode) {
    while (tcsetattr(STDIN_FILENO, TCSANOW, &mode) != 0 && errno == EINTR) {
    }
}

void onEnd(int signal, siginfo_t* info, void* context) {
    restoreTerminal();
    // The default action is in force again (SA_RESETHAND), as the previous handlers expect.
    const struct sigaction& previous = before[signal];
    if (previous.sa_flags & SA_SIGINFO)
        previous.sa_sigaction(signal, info, context);
    else if (previous.sa_handler != SIG_DFL)
        previous.sa_handler(signal);
    else if (info->si_code <= 0 || !isFault(signal))
        raise(signal);  // a fault is repeated when this returns, a signal that was sent is not
}

/** Stops the process as usual, but restores the terminal before and sets it again afterwards. */
void onStop(int signal, siginfo_t*, void*) {
    const int error = errno;
    termios now;
    // In the background, the mode is the shell's and must not be restored later.
    const bool known = maySetTerminal() && tcgetattr(STDIN_FILENO, &now) == 0;
    restoreTerminal();
    struct sigaction usual = {}, own = {};
    usual.sa_handler = SIG_DFL;
    own.sa_sigaction = &onStop;
    own.sa_flags = SA_SIGINFO | SA_RESTART;
    sigaction(signal, &usual, nullptr);
    raise(signal);
    sigset_t only, masked;
    sigemptyset(&only);
    sigaddset(&only, signal);
    pthread_sigmask(SIG_UNBLOCK, &only, &masked);  // the process stops here
    pthread_sigmask(SIG_SETMASK, &masked, nullptr);
    if (kept) sigaction(signal, &own, nullptr);
    if (known && maySetTerminal()) set(now);
    errno = error;
}

}  // namespace

bool maySetTerminal() {
    const int error = errno;
    const pid_t group = tcgetpgrp(STDIN_FILENO);
    // A process is stopped only by the terminal that controls it.
    const bool may = kept && getpid() == owner && (group == getpgrp() || (group < 0 && errno == ENOTTY));
    errno = error;
    return may;
}

void restoreTerminal() {
    if (!maySetTerminal()) return;
    const int error = errno;
    if (paste && write(STDOUT_FILENO, kUnmarkPaste, sizeof kUnmarkPaste - 1) < 0) {
        // There is nobody to report a failure to.
    }
    set(original);
    errno = error;
}

void setPasteMarked(bool marked) { paste = marked; }

KeptTerminal::KeptTerminal() {
    if (tcgetattr(STDIN_FILENO, &original) != 0) return;
    static const int atEnd = std::atexit(restoreTerminal);
    (void)atEnd;
    owner = getpid();
    kept = 1;
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGQUIT, SIGHUP, SIGINT, SIGTERM, SIGPIPE,
                             SIGALRM, SIGUSR1, SIGUSR2, SIGXCPU, SIGXFSZ, SIGTRAP, SIGVTALRM, SIGSYS})
        handle(signal, &onEnd, static_cast<int>(SA_SIGINFO | SA_RESETHAND | SA_ONSTACK));
    handle(SIGTSTP, &onStop, SA_SIGINFO | SA_RESTART);
}

KeptTerminal::~KeptTerminal() {
    if (!kept) return;
    restoreTerminal();
    kept = 0;
    for (const int signal : handled_) {
        struct sigaction now = {};
        // Other code may have replaced the handler, and after its execution it is not installed any more.
        if (sigaction(signal, nullptr, &now) == 0 && (isHandler(now, &onEnd) || isHandler(now, &onStop)))
            sigaction(signal, &before[signal], nullptr);
    }
}

void KeptTerminal::handle(int signal, void (*handler)(int, siginfo_t*, void*), int flags) {
    struct sigaction previous = {};
    if (sigaction(signal, nullptr, &previous) != 0) return;
    // Leaves ignored signals and other handlers alone, except those of crashes, which end the process anyway.
    const bool plain = !(previous.sa_flags & SA_SIGINFO);
    const bool usual = plain && previous.sa_handler == SIG_DFL, ignored = plain && previous.sa_handler == SIG_IGN;
    if (ignored || (!usual && !isFault(signal) && signal != SIGABRT && signal != SIGQUIT)) return;
    before[signal] = previous;
    struct sigaction action = {};
    action.sa_sigaction = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    if (sigaction(signal, &action, nullptr) == 0) handled_.push_back(signal);
}

}  // namespace OCL::console
