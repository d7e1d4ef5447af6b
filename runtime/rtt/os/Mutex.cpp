// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/Mutex.hpp>

#include <rtt/os/fosi.h>

#include <cassert>
#include <cerrno>

namespace RTT::os {

namespace {

void create(pthread_mutex_t& mutex, int type) {
    pthread_mutexattr_t attributes;
    pthread_mutexattr_init(&attributes);
    pthread_mutexattr_settype(&attributes, type);
    pthread_mutexattr_setprotocol(&attributes, PTHREAD_PRIO_INHERIT);
    pthread_mutex_init(&mutex, &attributes);
    pthread_mutexattr_destroy(&attributes);
}

void lockNow(pthread_mutex_t& mutex) {
    const int error = pthread_mutex_lock(&mutex);
    assert(error == 0);
    (void)error;
}

bool lockWithin(pthread_mutex_t& mutex, Seconds timeout) {
    const nsecs now = rtos_get_time_ns();
    const nsecs wait = timeout > 0 ? Seconds_to_nsecs(timeout) : 0;
    if (wait > InfiniteNSecs - now) return pthread_mutex_lock(&mutex) == 0;
#ifndef __SANITIZE_THREAD__  // it does not know this function and would take the mutex for unlocked
    const TIME_SPEC deadline = ticks2timespec(now + wait);
    const int error = pthread_mutex_clocklock(&mutex, CLOCK_MONOTONIC, &deadline);
    if (error != EINVAL) return error == 0;
#endif
    // For a mutex that inherits priority, kernels before 5.14 support only the wall clock.
    TIME_SPEC wall;
    clock_gettime(CLOCK_REALTIME, &wall);
    const TIME_SPEC wallDeadline = ticks2timespec(wall.tv_sec * 1000000000LL + wall.tv_nsec + wait);
    return pthread_mutex_timedlock(&mutex, &wallDeadline) == 0;
}

}  // namespace

MutexInterface::~MutexInterface() = default;
bool MutexInterface::trylock_shared() { return false; }
bool MutexInterface::timedlock_shared(Seconds) { return false; }

Mutex::Mutex() { create(mutex_, PTHREAD_MUTEX_NORMAL); }
Mutex::~Mutex() { pthread_mutex_destroy(&mutex_); }
void Mutex::lock() { lockNow(mutex_); }
void Mutex::unlock() { pthread_mutex_unlock(&mutex_); }
bool Mutex::trylock() { return pthread_mutex_trylock(&mutex_) == 0; }
bool Mutex::timedlock(Seconds timeout) { return lockWithin(mutex_, timeout); }

MutexRecursive::MutexRecursive() { create(mutex_, PTHREAD_MUTEX_RECURSIVE); }
MutexRecursive::~MutexRecursive() { pthread_mutex_destroy(&mutex_); }
void MutexRecursive::lock() { lockNow(mutex_); }
void MutexRecursive::unlock() { pthread_mutex_unlock(&mutex_); }
bool MutexRecursive::trylock() { return pthread_mutex_trylock(&mutex_) == 0; }
bool MutexRecursive::timedlock(Seconds timeout) { return lockWithin(mutex_, timeout); }

SharedMutex::SharedMutex() {
    pthread_rwlockattr_t attributes;
    pthread_rwlockattr_init(&attributes);
    pthread_rwlockattr_setkind_np(&attributes, PTHREAD_RWLOCK_PREFER_WRITER_NONRECURSIVE_NP);
    pthread_rwlock_init(&lock_, &attributes);
    pthread_rwlockattr_destroy(&attributes);
}
SharedMutex::~SharedMutex() { pthread_rwlock_destroy(&lock_); }
void SharedMutex::lock() { pthread_rwlock_wrlock(&lock_); }
void SharedMutex::unlock() { pthread_rwlock_unlock(&lock_); }
void SharedMutex::lock_shared() { pthread_rwlock_rdlock(&lock_); }
void SharedMutex::unlock_shared() { pthread_rwlock_unlock(&lock_); }

}  // namespace RTT::os
