// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORELIB_DATAOBJECT_HPP
#define ORO_CORELIB_DATAOBJECT_HPP

#include <rtt/base/DataObjectLockFree.hpp>
#include <rtt/base/DataObjectLocked.hpp>

namespace RTT {
namespace base {

/** The usual kind of data object. */
template <class T>
class DataObject : public DataObjectLockFree<T> {
public:
    using DataObjectLockFree<T>::DataObjectLockFree;
};

}  // namespace base
}  // namespace RTT

#endif
