// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_REFERENCE_HPP
#define ORO_REFERENCE_HPP

#include <rtt/base/DataSourceBase.hpp>

namespace RTT {
namespace internal {

/** A source that can be made to refer to another value of its type. Not thread safe; real-time safe. */
class Reference {
public:
    virtual ~Reference() = default;

    /** Refers to the value at `ref`, which must be of the source's type and outlive it. */
    virtual void setReference(void* ref) = 0;
    /** Refers to the value of `source`; false, without a change, if that has another type or is read-only. */
    virtual bool setReference(base::DataSourceBase::shared_ptr source) = 0;
};

}  // namespace internal
}  // namespace RTT

#endif
