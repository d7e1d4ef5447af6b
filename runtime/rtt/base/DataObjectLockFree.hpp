// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef CORELIB_DATAOBJECT_LOCK_FREE_HPP
#define CORELIB_DATAOBJECT_LOCK_FREE_HPP

#include <rtt/internal/flow/stored_data_object.hpp>

namespace RTT {
namespace base {

/** For any number of writers and readers; never blocks. Set() fails only while too many threads use it. */
template <class T>
class DataObjectLockFree : public internal::StoredDataObject<T> {
public:
    typedef DataObjectBase::Options Options;

    /** The number of threads that may use this at once. */
    const unsigned int MAX_THREADS;

    DataObjectLockFree() : DataObjectLockFree(Options()) {}
    explicit DataObjectLockFree(const Options& options)
        : internal::StoredDataObject<T>(internal::StoreSpec::LockFree, nullptr, options.max_threads()),
          MAX_THREADS(options.max_threads()) {}
    /** `initial_value` sizes the storage; it is not delivered as data. */
    explicit DataObjectLockFree(const T& initial_value, const Options& options = Options())
        : internal::StoredDataObject<T>(internal::StoreSpec::LockFree, &initial_value, options.max_threads()),
          MAX_THREADS(options.max_threads()) {}
};

}  // namespace base
}  // namespace RTT

#endif
