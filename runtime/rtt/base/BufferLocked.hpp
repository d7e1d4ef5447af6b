// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORELIB_BUFFER_LOCKED_HPP
#define ORO_CORELIB_BUFFER_LOCKED_HPP

#include <rtt/internal/flow/stored_buffer.hpp>

namespace RTT {
namespace base {

/** For any number of writers and readers, which wait for each other. */
template <class T>
class BufferLocked : public internal::StoredBuffer<T> {
public:
    typedef BufferBase::Options Options;

    explicit BufferLocked(unsigned int size, const Options& options = Options())
        : internal::StoredBuffer<T>(internal::StoreSpec::Locked, size, nullptr, options) {}
    /** `initial_value` sizes the elements; it is not delivered as data. */
    BufferLocked(unsigned int size, const T& initial_value, const Options& options = Options())
        : internal::StoredBuffer<T>(internal::StoreSpec::Locked, size, &initial_value, options) {}
};

}  // namespace base
}  // namespace RTT

#endif
