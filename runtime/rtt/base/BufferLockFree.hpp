// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORELIB_BUFFER_LOCK_FREE_HPP
#define ORO_CORELIB_BUFFER_LOCK_FREE_HPP

#include <rtt/internal/flow/stored_buffer.hpp>

namespace RTT {
namespace base {

/** For any number of writers and readers; never blocks. Push() also fails while too many threads use it. */
template <class T>
class BufferLockFree : public internal::StoredBuffer<T> {
public:
    typedef BufferBase::Options Options;

    explicit BufferLockFree(unsigned int size, const Options& options = Options())
        : internal::StoredBuffer<T>(internal::StoreSpec::LockFree, size, nullptr, options) {}
    /** `initial_value` sizes the elements; it is not delivered as data. */
    BufferLockFree(unsigned int size, const T& initial_value, const Options& options = Options())
        : internal::StoredBuffer<T>(internal::StoreSpec::LockFree, size, &initial_value, options) {}
};

}  // namespace base
}  // namespace RTT

#endif
