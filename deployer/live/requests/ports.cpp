// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ports.hpp"

#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/types/Types.hpp>

#include <set>

namespace OCL::live {
namespace {

using RTT::base::OutputPortInterface;
using RTT::base::PortInterface;

constexpr unsigned kDeepest = 16;

Source copyOfLast(const OutputPortInterface& port) {
    if (!port.hasLastWrittenValue() || port.getTypeInfo() == RTT::types::Types()->unknownType()) return nullptr;
    const Source last(port.getDataSource()), copy = port.getTypeInfo()->buildValue();
    // Another sample may replace it meanwhile; the source copies one of them.
    return last && copy && last->evaluate() && copy->update(last.get()) ? copy : nullptr;
}

}  // namespace

KnownPorts::KnownPorts(const Root& root, Visits& visits) {
    RTT::TaskContext* const deployer = visits.enter(root.gate);
    if (!deployer) return;
    std::set<const RTT::TaskContext*> seen{deployer};
    components_.emplace_back(deployer->getName(), deployer);
    for (const auto& [name, gate] : deployer->getPeerGates())
        if (RTT::TaskContext* const peer = visits.enter(gate); peer && seen.insert(peer).second)
            components_.emplace_back(name, peer);
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
    if (!peer) return id->toString();
    const std::string name = nameOf(peer);
    return name.empty() ? "another port" : name;
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

std::string policyText(const RTT::ConnPolicy& policy) {
    switch (policy.type) {
        case RTT::ConnPolicy::DATA: return "data";
        case RTT::ConnPolicy::BUFFER: return "buffer " + std::to_string(policy.size);
        case RTT::ConnPolicy::CIRCULAR_BUFFER: return "circular buffer " + std::to_string(policy.size);
        default: return "unbuffered";
    }
}

std::string typeOfPort(const PortInterface& port) {
    return RTT::types::Types()->toDot(port.getTypeInfo()->getTypeName());
}

}  // namespace OCL::live
