// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Holds one sample of T that threads write and read.
#ifndef ORO_CORELIB_DATAOBJECT_INTERFACE_HPP
#define ORO_CORELIB_DATAOBJECT_INTERFACE_HPP

#include <rtt/FlowStatus.hpp>
#include <rtt/base/DataObjectBase.hpp>

#include <boost/shared_ptr.hpp>

namespace RTT {
namespace base {

template <class T>
class DataObjectInterface : public DataObjectBase {
public:
    typedef boost::shared_ptr<DataObjectInterface<T>> shared_ptr;
    typedef T value_t;
    typedef T& reference_t;
    typedef const T& param_t;
    typedef T DataType;

    /** NewData the first time after a Set(), then OldData; NoData, and `pull` untouched, before the first. */
    virtual FlowStatus Get(reference_t pull, bool copy_old_data = true) const = 0;
    /** A default value if there is none. */
    virtual value_t Get() const = 0;
    /** False if the sample could not be stored. */
    virtual bool Set(param_t push) = 0;
    /** Sizes the storage for samples like this one; with `reset` also drops the current one. Not real-time safe. */
    virtual bool data_sample(param_t sample, bool reset = true) = 0;
    virtual value_t data_sample() const = 0;
};

}  // namespace base
}  // namespace RTT

#endif
