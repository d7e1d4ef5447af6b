// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "find_port.hpp"

#include <rtt/ExecutionEngine.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/dotted_name.hpp>

#include <vector>

namespace OCL::live {
namespace {

typedef boost::intrusive_ptr<const RTT::internal::EngineGate> Gate;
typedef RTT::internal::EngineGate::Visit Visit;

RTT::TaskContext* componentOf(const Visit& visit) {
    RTT::ExecutionEngine* const engine = visit.engine();
    return engine ? dynamic_cast<RTT::TaskContext*>(engine->getTaskCore()) : nullptr;
}

Gate peerOf(const RTT::TaskContext& component, const std::string& name) {
    for (const auto& [peer, gate] : component.getPeerGates())
        if (peer == name) return gate;
    return nullptr;
}

std::unique_ptr<PortWatch> watchIn(const Gate& gate, const std::vector<std::string>& parts, std::size_t next,
                                   const PortWatch::Options& options, std::string& why) {
    const Visit visit(*gate);
    RTT::TaskContext* const component = componentOf(visit);
    if (!component || next == parts.size()) return nullptr;
    if (next + 1 < parts.size())
        if (const Gate peer = peerOf(*component, parts[next])) return watchIn(peer, parts, next + 1, options, why);
    if (next == 0 && parts.size() > 1 && (parts[0] == component->getName() || parts[0] == "this")) next = 1;
    RTT::Service::shared_ptr service = component->provides();
    while (next + 1 < parts.size() && service) service = service->getService(parts[next++]);
    RTT::base::PortInterface* const port = service ? service->getPort(parts[next]) : nullptr;
    if (!port) return nullptr;
    if (RTT::base::OutputPortInterface* const output = port->asOutput()) return PortWatch::make(*output, options, why);
    why = "it is an input; watch the output that is connected to it";
    return nullptr;
}

}  // namespace

std::unique_ptr<PortWatch> watchPort(const Gate& deployer, const std::string& path, const PortWatch::Options& options,
                                     std::string& why) {
    std::unique_ptr<PortWatch> made = watchIn(deployer, RTT::internal::partsOf(path), 0, options, why);
    if (!made) why = why.empty() ? "there is no port '" + path + "'" : "port '" + path + "' cannot be watched: " + why;
    return made;
}

}  // namespace OCL::live
