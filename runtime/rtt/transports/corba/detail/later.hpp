// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_LATER_HPP
#define ORO_CORBA_DETAIL_LATER_HPP

#include <functional>

namespace RTT {
namespace corba {
namespace detail {

/** Has a thread of this library call `work`, in the order of the calls of later(). For remote calls that must not be
    made with a lock held. Exceptions of CORBA are ignored. */
void later(std::function<void()> work);
/** Blocks until that is done, five seconds at most, and ends the thread until the next call. */
void endLater();

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
