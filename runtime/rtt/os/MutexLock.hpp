// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_MUTEX_LOCK_HPP
#define ORO_OS_MUTEX_LOCK_HPP

#include <rtt/os/Mutex.hpp>

namespace RTT {
namespace os {

/** Holds a mutex from construction to destruction. Blocks while constructing. */
class MutexLock {
public:
    explicit MutexLock(MutexInterface& mutex) : mutex_(mutex) { mutex_.lock(); }
    ~MutexLock() { mutex_.unlock(); }
    MutexLock(const MutexLock&) = delete;
    MutexLock& operator=(const MutexLock&) = delete;

private:
    MutexInterface& mutex_;
};

/** Holds a mutex shared with other readers from construction to destruction. Blocks while constructing. */
class SharedMutexLock {
public:
    explicit SharedMutexLock(MutexInterface& mutex) : mutex_(mutex) { mutex_.lock_shared(); }
    ~SharedMutexLock() { mutex_.unlock_shared(); }
    SharedMutexLock(const SharedMutexLock&) = delete;
    SharedMutexLock& operator=(const SharedMutexLock&) = delete;

private:
    MutexInterface& mutex_;
};

/** Locks a mutex if it is free; never blocks. Check isSuccessful(). */
class MutexTryLock {
public:
    explicit MutexTryLock(MutexInterface& mutex) : mutex_(mutex), successful_(mutex.trylock()) {}
    ~MutexTryLock() {
        if (successful_) mutex_.unlock();
    }
    MutexTryLock(const MutexTryLock&) = delete;
    MutexTryLock& operator=(const MutexTryLock&) = delete;
    bool isSuccessful() const { return successful_; }

private:
    MutexInterface& mutex_;
    const bool successful_;
};

/** Waits at most `timeout` seconds for a mutex. Check isSuccessful(). */
class MutexTimedLock {
public:
    MutexTimedLock(MutexInterface& mutex, Seconds timeout) : mutex_(mutex), successful_(mutex.timedlock(timeout)) {}
    ~MutexTimedLock() {
        if (successful_) mutex_.unlock();
    }
    MutexTimedLock(const MutexTimedLock&) = delete;
    MutexTimedLock& operator=(const MutexTimedLock&) = delete;
    bool isSuccessful() const { return successful_; }

private:
    MutexInterface& mutex_;
    const bool successful_;
};

}  // namespace os
}  // namespace RTT
#endif
