// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_BUFFER_HPP
#define ORO_BUFFER_HPP

#include <rtt/base/BufferLockFree.hpp>
#include <rtt/base/BufferLocked.hpp>

namespace RTT {
namespace base {

/** The usual kind of buffer. */
template <class T>
class Buffer : public BufferLockFree<T> {
public:
    using BufferLockFree<T>::BufferLockFree;
};

}  // namespace base
}  // namespace RTT

#endif
