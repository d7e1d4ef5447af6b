// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_SIGNALS_HPP
#define OROFORGE_DEPLOYMENT_SIGNALS_HPP

#include <signal.h>

#include <initializer_list>
#include <vector>

namespace OCL::deploy {

/**
 * Catches signals for its life time; a second one of the same kind that nobody waits for has its usual effect, so that
 * a program that hangs can still be ended. Of several, one inside the life time of another, the innermost catches.
 */
class SignalCatcher {
public:
    explicit SignalCatcher(std::initializer_list<int> signals);
    ~SignalCatcher();
    SignalCatcher(const SignalCatcher&) = delete;
    SignalCatcher& operator=(const SignalCatcher&) = delete;

    /** False if one of the signals cannot be caught. */
    bool ready() const { return ready_; }
    /** Blocks until one of the signals has come since construction, or one that an outer catcher has not waited for yet;
        returns its number. */
    int wait();
    /** True if wait() would not block. */
    bool caught() const;
    /** Can be read as soon as a signal was caught. */
    int descriptor() const { return pipe_[0]; }

private:
    struct Previous {
        int signal;
        struct sigaction action;
    };
    std::vector<Previous> previous_;
    bool ready_ = true;
    int outerPipe_[2];
    int pipe_[2];
};

}  // namespace OCL::deploy

#endif
