// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_SEMAPHORE_HPP
#define ORO_OS_SEMAPHORE_HPP

#include <rtt/rtt-config.h>

#include <cerrno>
#include <semaphore.h>

namespace RTT {
namespace os {

/** A counter that threads wait for. signal() and trywait() are real-time safe and do not block. */
class Semaphore {
public:
    explicit Semaphore(int count) { sem_init(&semaphore_, 0, static_cast<unsigned>(count)); }
    ~Semaphore() { sem_destroy(&semaphore_); }
    Semaphore(const Semaphore&) = delete;
    Semaphore& operator=(const Semaphore&) = delete;

    /** Blocks until the counter is above zero, then takes one. */
    void wait() {
        while (sem_wait(&semaphore_) == -1 && errno == EINTR) {
        }
    }
    /** Adds one and wakes one waiter. */
    void signal() { sem_post(&semaphore_); }
    /** Takes one if there is one. */
    bool trywait() { return sem_trywait(&semaphore_) == 0; }
    /** The counter at some moment during the call. */
    int value() {
        int count = 0;
        sem_getvalue(&semaphore_, &count);
        return count;
    }

private:
    sem_t semaphore_;
};

}  // namespace os
}  // namespace RTT
#endif
