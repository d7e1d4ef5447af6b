// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/Condition.hpp>

#include <rtt/os/fosi.h>

#include <cerrno>

namespace RTT::os {

Condition::Condition() {
    pthread_condattr_t attributes;
    pthread_condattr_init(&attributes);
    pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
    pthread_cond_init(&condition_, &attributes);
    pthread_condattr_destroy(&attributes);
}

Condition::~Condition() { pthread_cond_destroy(&condition_); }

void Condition::wait(Mutex& mutex) { pthread_cond_wait(&condition_, &mutex.mutex_); }

void Condition::broadcast() { pthread_cond_broadcast(&condition_); }

bool Condition::wait_until(Mutex& mutex, nsecs deadline) {
    const TIME_SPEC until = ticks2timespec(deadline > 0 ? deadline : 0);
    return pthread_cond_timedwait(&condition_, &mutex.mutex_, &until) != ETIMEDOUT;
}

}  // namespace RTT::os
