// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "crash_report.hpp"

#include <rtt/internal/engine/hook_in_progress.hpp>

#include <cerrno>
#include <cstdint>
#include <cstring>

#include <execinfo.h>
#include <signal.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

namespace OCL::deploy {
namespace {

const int kSignals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

// Safe in a signal handler: no allocation, no locks, no stdio.
class Line {
public:
    Line& operator<<(const char* text) {
        while (*text && length_ < sizeof buffer_ - 1) buffer_[length_++] = *text++;
        return *this;
    }
    Line& operator<<(const void* address) {
        char digits[2 * sizeof(std::uintptr_t) + 1];
        char* at = digits + sizeof digits - 1;
        *at = '\0';
        auto value = reinterpret_cast<std::uintptr_t>(address);
        do {
            *--at = "0123456789abcdef"[value % 16];
            value /= 16;
        } while (value != 0);
        return *this << "0x" << at;
    }
    ~Line() {
        buffer_[length_++] = '\n';
        const ssize_t written = write(STDERR_FILENO, buffer_, length_);
        (void)written;
    }

private:
    char buffer_[1024];
    std::size_t length_ = 0;
};

const char* meaningOf(int signal) {
    switch (signal) {
        case SIGSEGV: return "it used memory that it has no access to (SIGSEGV)";
        case SIGBUS: return "it used memory that is not there (SIGBUS)";
        case SIGFPE: return "an integer was divided by zero, or overflowed (SIGFPE)";
        case SIGILL: return "an illegal instruction (SIGILL)";
        default: return "abort() was called (SIGABRT)";
    }
}

/** The stack pointer at the time of the signal; 0 if unknown. */
std::uintptr_t stackPointer(const void* context) {
#if defined(__x86_64__)
    return static_cast<std::uintptr_t>(static_cast<const ucontext_t*>(context)->uc_mcontext.gregs[REG_RSP]);
#elif defined(__i386__)
    return static_cast<std::uintptr_t>(static_cast<const ucontext_t*>(context)->uc_mcontext.gregs[REG_ESP]);
#elif defined(__aarch64__)
    return static_cast<std::uintptr_t>(static_cast<const ucontext_t*>(context)->uc_mcontext.sp);
#else
    (void)context;
    return 0;
#endif
}

/** Tests by a system call that is refused, but only after it has read a signal mask from the address. */
bool isReadable(std::uintptr_t address) {
    const int kNothing = -1;
    constexpr std::size_t kMaskSize = 8;
    return syscall(SYS_rt_sigprocmask, kNothing, address, nullptr, kMaskSize) == 0 || errno != EFAULT;
}

/** True if nothing more can be put on the stack. */
bool isStackUsedUp(const void* context) {
    const std::uintptr_t pointer = stackPointer(context);
    constexpr std::uintptr_t kNextCall = 256;
    return pointer > kNextCall && !isReadable((pointer - kNextCall) & ~std::uintptr_t{7});
}

struct sigaction previous[NSIG];

void tell(int signal, siginfo_t* info, void* context) {
    {
        Line line;
        line << "error: ";
        if (const auto* const hook = RTT::internal::HookInProgress::innermost())
            line << "component '" << hook->component << "' crashed in " << hook->hook << ": ";
        else
            line << "a crash outside of all components: ";
        const bool overflow = signal == SIGSEGV && isStackUsedUp(context);
        if (overflow)
            line << "it used up the stack of its thread, by calls within calls without end or by large variables "
                    "(SIGSEGV)";
        else
            line << meaningOf(signal);
        if (signal == SIGSEGV || signal == SIGBUS) line << ", at address " << info->si_addr;
    }
    void* frames[64];
    const int count = backtrace(frames, 64);
    // The first two are this function and the system's, which called it.
    const int own = count > 2 ? 2 : 0;
    backtrace_symbols_fd(frames + own, count - own, STDERR_FILENO);
    // The default action is in force again. The previous handler may have work to do, such as writing the last log
    // lines.
    const struct sigaction& before = previous[signal];
    if (before.sa_flags & SA_SIGINFO)
        before.sa_sigaction(signal, info, context);
    else if (before.sa_handler != SIG_DFL)
        before.sa_handler(signal);
    else if (info->si_code <= 0)
        raise(signal);  // a fault is repeated when this returns, a signal that was sent is not
}

}  // namespace

void reportCrashes() {
    static char handlersStack[64 * 1024];  // for this thread; threads of components have their own
    stack_t stack;
    std::memset(&stack, 0, sizeof stack);
    if (sigaltstack(nullptr, &stack) == 0 && (stack.ss_flags & SS_DISABLE) != 0) {
        stack.ss_sp = handlersStack;
        stack.ss_size = sizeof handlersStack;
        stack.ss_flags = 0;
        sigaltstack(&stack, nullptr);
    }
    void* frame;
    (void)backtrace(&frame, 1);  // loads a library, which must not happen in a handler
    for (const int signal : kSignals) {
        if (sigaction(signal, nullptr, &previous[signal]) != 0 || previous[signal].sa_handler == SIG_IGN) continue;
        struct sigaction action;
        std::memset(&action, 0, sizeof action);
        action.sa_sigaction = &tell;
        action.sa_flags = static_cast<int>(SA_SIGINFO | SA_RESETHAND | SA_ONSTACK);
        sigemptyset(&action.sa_mask);
        sigaction(signal, &action, nullptr);
    }
}

}  // namespace OCL::deploy
