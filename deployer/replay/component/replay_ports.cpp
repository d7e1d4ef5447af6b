// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "replay_ports.hpp"

#include <sstream>

namespace OCL::replay {

bool ReplayPorts::add(const Topic& topic, RTT::base::OutputPortInterface& port, std::string& why) {
    RTT::Service::shared_ptr service = component_.provides();
    std::istringstream path(topic.component + "." + topic.port);
    for (std::string part; std::getline(path, part, '.');) {
        if (path.eof()) break;  // the port itself
        if (part.empty() || part == "this") continue;
        if (!service->hasService(part)) services_.emplace_back(service, part);
        service = service->provides(part);
    }
    if (service->getPort(port.getName())) {
        why = "error: [MCP020] topic '" + topic.topic + "': there is a port '" + port.getName() + "' in the service '" +
              service->getName() + "' already; choose one of both by the property Topics";
        return false;
    }
    service->addPort(port).doc("Repeats the topic " + topic.topic + " of the recording.");
    ports_.emplace_back(service, port.getName());
    return true;
}

void ReplayPorts::remove() {
    for (const auto& [service, name] : ports_) service->removePort(name);
    ports_.clear();
    for (; !services_.empty(); services_.pop_back()) services_.back().first->removeService(services_.back().second);
}

}  // namespace OCL::replay
