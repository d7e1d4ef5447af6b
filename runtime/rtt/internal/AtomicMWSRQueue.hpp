// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ATOMIC_MWSR_QUEUE_HPP
#define ORO_ATOMIC_MWSR_QUEUE_HPP

#include <rtt/internal/AtomicQueue.hpp>

namespace RTT {
namespace internal {

/** A queue for many writers and one reader, which may look at the first value before it takes it. */
template <class T>
class AtomicMWSRQueue : public AtomicQueue<T> {
public:
    using AtomicQueue<T>::AtomicQueue;

    /** The value that dequeue() would give next, or `T()`. Only for the reader's thread. */
    T front() const { return this->firstValue(); }
};

}  // namespace internal
}  // namespace RTT

#endif
