// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The locks of LOCKED and UNSYNC storages.
#ifndef ORO_INTERNAL_DETAIL_STORE_LOCK_HPP
#define ORO_INTERNAL_DETAIL_STORE_LOCK_HPP

#include <rtt/os/Mutex.hpp>

namespace RTT {
namespace internal {
namespace detail {

struct NoMutex {
    void lock() {}
    void unlock() {}
};

/** Holds a lock for a scope. Unlike os::MutexLock it calls the mutex's own functions, not those of its interface. */
template <class Mutex>
class Hold {
public:
    explicit Hold(Mutex& mutex) : mutex_(mutex) { mutex_.Mutex::lock(); }
    ~Hold() { mutex_.Mutex::unlock(); }
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

private:
    Mutex& mutex_;
};
template <>
class Hold<NoMutex> {
public:
    explicit Hold(NoMutex&) {}
    ~Hold() {}
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
