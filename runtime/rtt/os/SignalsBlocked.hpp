// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_SIGNALS_BLOCKED_HPP
#define ORO_OS_SIGNALS_BLOCKED_HPP

#include <pthread.h>
#include <signal.h>

namespace RTT {
namespace os {

/** Blocks all signals for this thread while it exists. A thread that is started meanwhile never handles one: signals of
    the process are for older threads. */
class SignalsBlocked {
public:
    SignalsBlocked() noexcept {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsBlocked(const SignalsBlocked&) = delete;
    SignalsBlocked& operator=(const SignalsBlocked&) = delete;

private:
    sigset_t before_;
};

}  // namespace os
}  // namespace RTT

#endif
