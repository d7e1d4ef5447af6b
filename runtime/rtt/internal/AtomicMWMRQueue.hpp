// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ATOMIC_MWMR_QUEUE_HPP
#define ORO_ATOMIC_MWMR_QUEUE_HPP

#include <rtt/internal/AtomicQueue.hpp>

namespace RTT {
namespace internal {

/** A queue for many writers and many readers. */
template <class T>
class AtomicMWMRQueue : public AtomicQueue<T> {
public:
    using AtomicQueue<T>::AtomicQueue;
};

}  // namespace internal
}  // namespace RTT

#endif
