// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_SIGNALS_HPP
#define OROFORGE_DEPLOYMENT_SIGNALS_HPP

#include <signal.h>

#include <atomic>
#include <initializer_list>
#include <vector>

namespace OCL::deploy {

/** SIGINT, SIGTERM or SIGHUP if it was caught and nobody has waited for it yet; 0 if there is none. Any thread. */
int pendingSignal();

/** Done before a second signal ends the process: what puts the terminal back, say. It must be safe in signal handlers. */
void beforeSecondSignal(void (*action)());

/**
 * Catches signals for its life time; a second one that nobody waits for has its usual effect, so that a program that hangs
 * can still be ended. Of several, also of several threads, the one that was made last and is for a signal catches it.
 */
class SignalCatcher {
public:
    explicit SignalCatcher(std::initializer_list<int> signals);
    ~SignalCatcher();
    SignalCatcher(const SignalCatcher&) = delete;
    SignalCatcher& operator=(const SignalCatcher&) = delete;

    /** False if one of the signals cannot be caught. */
    bool ready() const { return ready_; }
    /** Blocks until one of the signals has come since construction, or one that ends the program and was caught by an earlier
        catcher; returns its number. */
    int wait();
    /** Done in the handler when a signal comes and none is waiting; null: nothing. It must be safe in signal handlers. */
    void atFirst(void (*action)()) { atFirst_ = action; }
    /** True if wait() would not block. */
    bool caught() const { return caught_ != 0; }
    /** Can be read as soon as a signal was caught. */
    int descriptor() const { return pipe_[0]; }

private:
    friend int pendingSignal();
    static void onSignal(int signal);
    bool catchesEnd() const;

    struct Previous {
        int signal;
        SignalCatcher* catcher;
        struct sigaction action;
    };
    std::vector<Previous> previous_;
    SignalCatcher* outer_;
    std::atomic<int> caught_{0};  // and not waited for
    std::atomic<void (*)()> atFirst_{nullptr};
    bool ready_ = true;
    int pipe_[2];
};

}  // namespace OCL::deploy

#endif
