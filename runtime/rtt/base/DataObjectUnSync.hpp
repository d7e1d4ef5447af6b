// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_DATAOBJECT_UNSYNC_HPP
#define ORO_DATAOBJECT_UNSYNC_HPP

#include <rtt/base/DataObject.hpp>

namespace RTT {
namespace base {

/** For one thread at a time. */
template <class T>
class DataObjectUnSync : public DataObject<T> {
public:
    typedef DataObjectBase::Options Options;

    DataObjectUnSync() : DataObject<T>(internal::StoreSpec::Unsync, nullptr, 2) {}
    explicit DataObjectUnSync(const Options& options)
        : DataObject<T>(internal::StoreSpec::Unsync, nullptr, options.max_threads()) {}
    /** `initial_value` sizes the storage; it is not delivered as data. */
    explicit DataObjectUnSync(const T& initial_value, const Options& options = Options())
        : DataObject<T>(internal::StoreSpec::Unsync, &initial_value, options.max_threads()) {}
};

}  // namespace base
}  // namespace RTT

#endif
