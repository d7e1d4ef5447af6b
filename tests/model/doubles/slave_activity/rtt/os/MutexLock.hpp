// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header, for the mutexes of the checker's.
#ifndef OROFORGE_MODEL_MUTEX_LOCK_HPP
#define OROFORGE_MODEL_MUTEX_LOCK_HPP

#include <rtt/os/Mutex.hpp>

namespace RTT {
namespace os {

template <class AnyMutex>
class MutexLock {
public:
    explicit MutexLock(AnyMutex& mutex) : mutex_(mutex) { mutex_.lock(); }
    ~MutexLock() { mutex_.unlock(); }

private:
    AnyMutex& mutex_;
};

}  // namespace os
}  // namespace RTT
#endif
