// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_MUTEX_HPP
#define ORO_OS_MUTEX_HPP

#include <rtt/os/MutexInterface.hpp>

#include <pthread.h>

namespace RTT {
namespace os {

class Condition;

/**
 * A mutex that its holder must not lock again. Inherits priority: a holder of low priority runs at the priority
 * of the highest waiter.
 */
class RTT_API Mutex : public MutexInterface {
public:
    Mutex();
    ~Mutex() override;
    Mutex(const Mutex&) = delete;
    Mutex& operator=(const Mutex&) = delete;

    void lock() override;
    void unlock() override;
    bool trylock() override;
    bool timedlock(Seconds timeout) override;
    void lock_shared() override { lock(); }
    void unlock_shared() override { unlock(); }

private:
    friend class Condition;
    pthread_mutex_t mutex_;
};

/** A mutex that its holder may lock again, and must unlock as often. */
class RTT_API MutexRecursive : public MutexInterface {
public:
    MutexRecursive();
    ~MutexRecursive() override;
    MutexRecursive(const MutexRecursive&) = delete;
    MutexRecursive& operator=(const MutexRecursive&) = delete;

    void lock() override;
    void unlock() override;
    bool trylock() override;
    bool timedlock(Seconds timeout) override;
    void lock_shared() override { lock(); }
    void unlock_shared() override { unlock(); }

private:
    pthread_mutex_t mutex_;
};

/**
 * Many readers or one writer; a waiting writer is served before new readers. Its try and timed functions always
 * return false without taking the mutex.
 */
class RTT_API SharedMutex : public MutexInterface {
public:
    SharedMutex();
    ~SharedMutex() override;
    SharedMutex(const SharedMutex&) = delete;
    SharedMutex& operator=(const SharedMutex&) = delete;

    void lock() override;
    void unlock() override;
    bool trylock() override { return false; }
    bool timedlock(Seconds) override { return false; }
    void lock_shared() override;
    void unlock_shared() override;

private:
    pthread_rwlock_t lock_;
};

}  // namespace os
}  // namespace RTT
#endif
