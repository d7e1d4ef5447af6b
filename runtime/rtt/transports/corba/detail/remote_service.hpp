// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_REMOTE_SERVICE_HPP
#define ORO_CORBA_DETAIL_REMOTE_SERVICE_HPP

#include <rtt/Service.hpp>
#include <rtt/transports/corba/ServiceC.h>
#include <rtt/transports/corba/detail/remote_peer.hpp>

#include <memory>
#include <string>
#include <vector>

namespace RTT {
namespace corba {
namespace detail {

/** The ports that stand for those of another process. */
typedef std::vector<std::unique_ptr<base::PortInterface>> RemotePortList;

/** Adds to `service`, which has that path, what the described one has and it does not have yet: operations,
    properties, attributes, ports and services. What it has already calls this reference from now on. Logs an error
    for types that no typekit of this process knows. Throws CORBA::Exception. */
void fill(Service& service, CService_ptr reference, const CServiceDescription& described,
          const std::shared_ptr<RemotePeer>& peer, RemotePortList& ports, const std::string& path = "");
/** A service of this process that calls another one; without its ports. What uses it finds that one again, see
    LoneService. Throws CORBA::Exception. */
Service::shared_ptr newRemoteService(CService_ptr reference);

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
