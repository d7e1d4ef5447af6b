// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The lock for connecting and disconnecting.
#ifndef ORO_INTERNAL_DETAIL_GRAPH_LOCK_HPP
#define ORO_INTERNAL_DETAIL_GRAPH_LOCK_HPP

#include <mutex>

namespace RTT {
namespace internal {
namespace detail {

/** Holds the one lock of all connections of the process: a single lock has no wrong order. Never hold it while code of
    users or transports may run. */
class GraphLock {
public:
    GraphLock() : lock_(mutex()) {}

private:
    /** Never destroyed, because ports with static storage disconnect while the process exits. */
    static std::mutex& mutex();
    std::lock_guard<std::mutex> lock_;
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
