// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef CORELIB_DATAOBJECT_LOCKED_HPP
#define CORELIB_DATAOBJECT_LOCKED_HPP

#include <rtt/internal/flow/stored_data_object.hpp>

namespace RTT {
namespace base {

/** For any number of writers and readers, which wait for each other. */
template <class T>
class DataObjectLocked : public internal::StoredDataObject<T> {
public:
    typedef DataObjectBase::Options Options;

    DataObjectLocked() : internal::StoredDataObject<T>(internal::StoreSpec::Locked, nullptr, 2) {}
    explicit DataObjectLocked(const Options& options)
        : internal::StoredDataObject<T>(internal::StoreSpec::Locked, nullptr, options.max_threads()) {}
    /** `initial_value` sizes the storage; it is not delivered as data. */
    explicit DataObjectLocked(const T& initial_value, const Options& options = Options())
        : internal::StoredDataObject<T>(internal::StoreSpec::Locked, &initial_value, options.max_threads()) {}
};

}  // namespace base
}  // namespace RTT

#endif
