// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_MUTEX_INTERFACE_HPP
#define ORO_OS_MUTEX_INTERFACE_HPP

#include <rtt/Time.hpp>
#include <rtt/rtt-config.h>

namespace RTT {
namespace os {

/**
 * The interface of all mutexes. lock() blocks until it has the mutex; trylock() never blocks; timedlock() blocks at
 * most the given number of seconds, measured on the monotonic clock. The shared functions lock the mutex together with
 * other shared holders if the implementation supports sharing, otherwise exclusively.
 */
class RTT_API MutexInterface {
public:
    virtual ~MutexInterface();
    virtual void lock() = 0;
    virtual void unlock() = 0;
    virtual bool trylock() = 0;
    virtual bool timedlock(Seconds timeout) = 0;
    virtual void lock_shared() = 0;
    virtual void unlock_shared() = 0;
    /** False unless the implementation supports it. */
    virtual bool trylock_shared();
    virtual bool timedlock_shared(Seconds timeout);
};

}  // namespace os
}  // namespace RTT
#endif
