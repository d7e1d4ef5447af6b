// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORELIB_BUFFER_UNSYNC_HPP
#define ORO_CORELIB_BUFFER_UNSYNC_HPP

#include <rtt/internal/flow/stored_buffer.hpp>

namespace RTT {
namespace base {

/** For one thread at a time. */
template <class T>
class BufferUnSync : public internal::StoredBuffer<T> {
public:
    typedef BufferBase::Options Options;

    explicit BufferUnSync(unsigned int size, const Options& options = Options())
        : internal::StoredBuffer<T>(internal::StoreSpec::Unsync, size, nullptr, options) {}
    /** `initial_value` sizes the elements; it is not delivered as data. */
    BufferUnSync(unsigned int size, const T& initial_value, const Options& options = Options())
        : internal::StoredBuffer<T>(internal::StoreSpec::Unsync, size, &initial_value, options) {}
};

}  // namespace base
}  // namespace RTT

#endif
