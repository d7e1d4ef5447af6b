// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The locks of LOCKED and UNSYNC storages.
#ifndef ORO_INTERNAL_DETAIL_STORE_LOCK_HPP
#define ORO_INTERNAL_DETAIL_STORE_LOCK_HPP

#include <rtt/os/priority_lock.hpp>

#include <atomic>
#include <cstdint>

namespace RTT {
namespace internal {
namespace detail {

struct NoMutex {};
/** Half the time of an os::Mutex while nobody waits. */
struct StoreMutex {
    std::atomic<std::uint32_t> word{0};
};

/** Holds a lock for a scope. */
template <class Mutex>
class Hold {
public:
    explicit Hold(Mutex& mutex) : lock_(mutex.word) {}

private:
    os::detail::PriorityLock lock_;
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
