// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The naming service: components are in the context "TaskContexts".
#ifndef ORO_CORBA_DETAIL_NAMING_HPP
#define ORO_CORBA_DETAIL_NAMING_HPP

#include <rtt/transports/corba/TaskContextC.h>

#include <string>

namespace RTT {
namespace corba {
namespace detail {

enum class Bound {
    New,
    Again,      ///< the name was that of another object, such as one of a process that has ended
    NoService,  ///< there is no naming service
    Failed
};

/** Blocks; `why` says what went wrong. */
Bound bindName(const std::string& name, CTaskContext_ptr component, std::string& why);
/** Removes the name if it is that of this component. */
void unbindName(const std::string& name, CTaskContext_ptr component);
/** Nil, with the reason in `why`, if there is none. The caller owns the reference. */
CTaskContext_ptr resolveName(const std::string& name, std::string& why);

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
