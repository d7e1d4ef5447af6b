// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "known_ports.hpp"

#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/types/Types.hpp>

#include <set>

namespace OCL::console {
namespace {

using RTT::base::OutputPortInterface;
using RTT::base::PortInterface;
typedef RTT::base::DataSourceBase::shared_ptr Source;

constexpr unsigned kDeepest = 16;

Source copyOfLast(const OutputPortInterface& port) {
    if (!port.hasLastWrittenValue() || port.getTypeInfo() == RTT::types::Types()->unknownType()) return nullptr;
    const Source last(port.getDataSource()), copy = port.getTypeInfo()->buildValue();
    // Another sample may replace it meanwhile; the source copies one of them.
    return last && copy && last->evaluate() && copy->update(last.get()) ? copy : nullptr;
}

}  // namespace

KnownPorts::KnownPorts(const std::vector<Gate>& roots, Visits& visits) {
    std::set<const RTT::TaskContext*> seen;
    const auto enter = [&](const Gate& gate, const std::string& name) {
        RTT::TaskContext* const component = visits.enter(gate);
        if (component && seen.insert(component).second)
            components_.emplace_back(name.empty() ? component->getName() : name, component);
        return component;
    };
    for (const Gate& root : roots)
        if (RTT::TaskContext* const component = enter(root, ""))
            for (const auto& [name, gate] : component->getPeerGates()) enter(gate, name);
    for (const auto& [name, component] : components_) add(name, *component->provides(), "", 0);
}

void KnownPorts::add(const std::string& component, RTT::Service& service, const std::string& prefix, unsigned depth) {
    if (depth > kDeepest) return;
    for (const PortInterface* const port : service.getPorts()) {
        const std::string name = prefix + port->getName();
        if (names_.emplace(port, component + "." + name).second) all_.push_back({component, name, port});
    }
    for (const std::string& name : service.getProviderNames())
        if (const auto inner = name == "this" ? nullptr : service.getService(name); inner && !service.getPort(name))
            add(component, *inner, prefix + name + ".", depth + 1);
}

std::string KnownPorts::nameOf(const PortInterface* port) const {
    const auto known = names_.find(port);
    return known == names_.end() ? std::string() : known->second;
}

std::string KnownPorts::partnerOf(const RTT::internal::ConnectionManager::ChannelDescriptor& connection) const {
    const auto& id = connection.get<0>();
    const PortInterface* const peer = id->peer() ? id->peer() : id->partner();
    const std::string name = peer ? nameOf(peer) : std::string();
    return name.empty() ? id->toString() : name;
}

Source KnownPorts::lastSample(const PortInterface& port) const {
    if (const auto* const output = port.asOutput()) return copyOfLast(*output);
    for (const auto& connection : port.getManager()->getConnections()) {
        const PortInterface* const peer = connection.get<0>()->peer();
        if (!peer || nameOf(peer).empty()) continue;
        const auto* const output = peer->asOutput();
        if (const Source last = output ? copyOfLast(*output) : nullptr) return last;
    }
    return nullptr;
}

Source lastSampleOf(const PortInterface& port, const std::vector<Gate>& roots) {
    Visits visits;
    return KnownPorts(roots, visits).lastSample(port);
}

}  // namespace OCL::console
