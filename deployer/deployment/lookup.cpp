// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "lookup.hpp"

#include "failure.hpp"
#include "session.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/DataFlowInterface.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/dotted_name.hpp>

namespace OCL::deploy {

RTT::TaskContext* findComponent(const Session& session, const std::string& name, const char* toDo) {
    RTT::TaskContext* component = session.component(name);
    if (!component)
        failed(std::string("could not ") + toDo + ": no component '" + name + "'" +
               oroforge::diag::didYouMean(name, session.componentNames()));
    return component;
}

RTT::Service::shared_ptr findService(RTT::TaskContext& component, const std::string& path, std::string& error) {
    const RTT::internal::ResolvedName found = RTT::internal::resolve(*component.provides(), path);
    if (!found.target.service)
        error = "no service '" + found.wrong + "' in component '" + component.getName() + "'" +
                oroforge::diag::didYouMean(found.wrong, found.known);
    return found.target.service;
}

RTT::base::PortInterface* findPort(RTT::TaskContext& component, const std::string& path) {
    return RTT::internal::findPort(*component.provides(), path);
}

RTT::base::PortInterface* findPort(const Session& session, const std::string& path, std::string& error) {
    const std::size_t dot = path.find('.');
    const std::string name = path.substr(0, dot);
    RTT::TaskContext* component = session.component(name);
    if (!component) {
        error = "no component '" + name + "'" + oroforge::diag::didYouMean(name, session.componentNames());
        return nullptr;
    }
    const std::string rest = dot == std::string::npos ? std::string() : path.substr(dot + 1);
    RTT::base::PortInterface* port = rest.empty() ? nullptr : findPort(*component, rest);
    if (!port)
        error = rest.empty() ? "'" + path + "' names no port, expected component.port"
                             : "component '" + name + "' has no port '" + rest + "'" +
                                   oroforge::diag::didYouMean(rest, portNames(*component));
    return port;
}

std::vector<std::string> portNames(RTT::TaskContext& component) { return component.ports()->getPortNames(); }

}  // namespace OCL::deploy
