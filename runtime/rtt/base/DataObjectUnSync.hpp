// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_DATAOBJECT_UNSYNC_HPP
#define ORO_DATAOBJECT_UNSYNC_HPP

#include <rtt/internal/flow/stored_data_object.hpp>

namespace RTT {
namespace base {

/** For one thread at a time. */
template <class T>
class DataObjectUnSync : public internal::StoredDataObject<T> {
public:
    typedef DataObjectBase::Options Options;

    DataObjectUnSync() : internal::StoredDataObject<T>(internal::StoreSpec::Unsync, nullptr, 2) {}
    explicit DataObjectUnSync(const Options& options)
        : internal::StoredDataObject<T>(internal::StoreSpec::Unsync, nullptr, options.max_threads()) {}
    /** `initial_value` sizes the storage; it is not delivered as data. */
    explicit DataObjectUnSync(const T& initial_value, const Options& options = Options())
        : internal::StoredDataObject<T>(internal::StoreSpec::Unsync, &initial_value, options.max_threads()) {}
};

}  // namespace base
}  // namespace RTT

#endif
