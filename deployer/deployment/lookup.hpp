// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Services and ports by path. A path is `[service.…]name`, relative to a component.
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

/** The component, or null after logging what could not be done because there is none. */
RTT::TaskContext* findComponent(const Session& session, const std::string& name, const char* toDo);

/** The service a path leads to, the component's own for an empty one; null, with the reason, if it leads nowhere. */
RTT::Service::shared_ptr findService(RTT::TaskContext& component, const std::string& path, std::string& error);

/** The port a path relative to the component leads to; null if there is none. */
RTT::base::PortInterface* findPort(RTT::TaskContext& component, const std::string& path);
/** As above for `component.path`; the reason of a failure in `error`. */
RTT::base::PortInterface* findPort(const Session& session, const std::string& path, std::string& error);

/** Names of the component's own ports. */
std::vector<std::string> portNames(RTT::TaskContext& component);

/** Splits at the last dot: path of the owner, and the last name. */
std::pair<std::string, std::string> splitPath(const std::string& path);

}  // namespace OCL::deploy

#endif
