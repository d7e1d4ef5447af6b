// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_REMOTE_REQUESTER_HPP
#define ORO_CORBA_DETAIL_REMOTE_REQUESTER_HPP

#include <rtt/OperationCaller.hpp>
#include <rtt/ServiceRequester.hpp>
#include <rtt/transports/corba/ServiceRequesterC.h>
#include <rtt/transports/corba/detail/remote_peer.hpp>

#include <memory>
#include <vector>

namespace RTT {
namespace corba {
namespace detail {

/** What stands for the callers of another process. */
typedef std::vector<std::unique_ptr<base::OperationCallerBaseInvoker>> RemoteCallerList;

/** Adds to `requester` what the described one has and it does not have yet. What it has already calls this reference
    from now on. */
void fill(ServiceRequester& requester, CServiceRequester_ptr reference, const CServiceRequesterDescription& described,
          const std::shared_ptr<RemotePeer>& peer, RemoteCallerList& callers);

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
