// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Looks up services and ports by path: `[service.…]name`, relative to a component.
#ifndef OROFORGE_DEPLOYMENT_LOOKUP_HPP
#define OROFORGE_DEPLOYMENT_LOOKUP_HPP

#include <rtt/Service.hpp>
#include <rtt/base/PortInterface.hpp>

#include <string>
#include <vector>

namespace RTT {
class TaskContext;
}

namespace OCL::deploy {

struct Session;

/** The component. If there is none, logs what could not be done and returns null. */
RTT::TaskContext* findComponent(const Session& session, const std::string& name, const char* toDo);

/** The service at the path; an empty path means the component's own. Null, with the reason, if there is none. */
RTT::Service::shared_ptr findService(RTT::TaskContext& component, const std::string& path, std::string& error);

/** The port at the path; null if there is none. */
RTT::base::PortInterface* findPort(RTT::TaskContext& component, const std::string& path);
/** As above for `component.path`; `error` gets the reason of a failure. */
RTT::base::PortInterface* findPort(const Session& session, const std::string& path, std::string& error);

/** Names of the component's own ports. */
std::vector<std::string> portNames(RTT::TaskContext& component);

}  // namespace OCL::deploy

#endif
