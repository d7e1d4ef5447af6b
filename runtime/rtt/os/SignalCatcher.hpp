// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_SIGNAL_CATCHER_HPP
#define ORO_OS_SIGNAL_CATCHER_HPP

#include <rtt/rtt-config.h>

#include <signal.h>

#include <atomic>
#include <initializer_list>
#include <vector>

namespace RTT {
namespace os {

/** SIGINT, SIGTERM or SIGHUP if it was caught and nobody has waited for it yet; 0 if there is none. May be called from
    any thread. */
RTT_API int pendingSignal();

/** Sets a function that is called before a second signal ends the process, for example to restore the terminal. It must
    be safe in signal handlers. */
RTT_API void beforeSecondSignal(void (*action)());

/**
 * Catches signals while it exists. A second signal that nobody waits for has its usual effect, so that a program that
 * hangs can still be ended. Of several catchers, in any threads, the one that was made last for a signal catches it.
 */
class RTT_API SignalCatcher {
public:
    explicit SignalCatcher(std::initializer_list<int> signals);
    ~SignalCatcher();
    SignalCatcher(const SignalCatcher&) = delete;
    SignalCatcher& operator=(const SignalCatcher&) = delete;

    /** False if one of the signals cannot be caught. */
    bool ready() const { return ready_; }
    /** Blocks until one of the signals has come since construction, or until an earlier catcher has caught one that
        ends the program. Returns its number. */
    int wait();
    /** Sets a function that the handler calls at the first signal, or null. It must be safe in signal handlers. */
    void atFirst(void (*action)()) { atFirst_ = action; }
    /** True if wait() would not block. */
    bool caught() const { return caught_ != 0; }
    /** Becomes readable when a signal was caught. */
    int descriptor() const { return pipe_[0]; }

private:
    friend RTT_API int pendingSignal();
    static void onSignal(int signal);
    bool catchesEnd() const;

    struct Previous {
        int signal;
        SignalCatcher* catcher;
        struct sigaction action;
    };
    std::vector<Previous> previous_;
    SignalCatcher* outer_;
    std::atomic<int> caught_{0};  // the signal, until somebody waits for it
    std::atomic<void (*)()> atFirst_{nullptr};
    bool ready_ = true;
    int pipe_[2];
};

}  // namespace os
}  // namespace RTT

#endif
