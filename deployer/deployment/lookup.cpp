// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "lookup.hpp"

#include "failure.hpp"
#include "session.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/DataFlowInterface.hpp>
#include <rtt/TaskContext.hpp>

namespace OCL::deploy {

std::pair<std::string, std::string> splitPath(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos) return {std::string(), path};
    return {path.substr(0, dot), path.substr(dot + 1)};
}

RTT::TaskContext* findComponent(const Session& session, const std::string& name, const char* toDo) {
    RTT::TaskContext* component = session.component(name);
    if (!component)
        failed(std::string("could not ") + toDo + ": no component '" + name + "'" +
               oroforge::diag::didYouMean(name, session.componentNames()));
    return component;
}

RTT::Service::shared_ptr findService(RTT::TaskContext& component, const std::string& path, std::string& error) {
    RTT::Service::shared_ptr service = component.provides();
    std::size_t begin = 0;
    while (begin < path.size()) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        const std::string name = path.substr(begin, end - begin);
        if (!service->hasService(name)) {
            error = "no service '" + name + "' in component '" + component.getName() + "'" +
                    oroforge::diag::didYouMean(name, service->getProviderNames());
            return RTT::Service::shared_ptr();
        }
        service = service->getService(name);
        begin = end + 1;
    }
    return service;
}

RTT::base::PortInterface* findPort(RTT::TaskContext& component, const std::string& path) {
    // Names may have dots, so the whole text is tried as a name before it is taken as a path.
    if (RTT::base::PortInterface* port = component.ports()->getPort(path)) return port;
    const auto parts = splitPath(path);
    std::string error;
    const RTT::Service::shared_ptr service = parts.first.empty() ? nullptr : findService(component, parts.first, error);
    return service ? service->getPort(parts.second) : nullptr;
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
