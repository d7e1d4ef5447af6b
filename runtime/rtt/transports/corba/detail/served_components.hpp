// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The components of this process that others can call.
#ifndef ORO_CORBA_DETAIL_SERVED_COMPONENTS_HPP
#define ORO_CORBA_DETAIL_SERVED_COMPONENTS_HPP

#include <rtt/Service.hpp>
#include <rtt/transports/corba/TaskContextC.h>

namespace RTT {
class TaskContext;
namespace corba {
namespace detail {

/** The service of this process that is behind a reference; null if it is in another one, or gone. */
Service::shared_ptr servedService(CORBA::Object_ptr reference);
/** The same for a component. */
TaskContext* servedComponent(CTaskContext_ptr reference);
/** The reference of a service whose component others can call; that becomes true now if it is not. Nil for a service
    without a component. The caller owns it. */
CService_ptr serve(Service& service);

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
