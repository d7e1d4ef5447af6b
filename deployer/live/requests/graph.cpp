// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The verb `graph`.
#include "ports.hpp"
#include "interface_json.hpp"
#include "verbs.hpp"

#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/flow/connection_facts.hpp>
#include <rtt/internal/flow/storage_core.hpp>

#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;

json connectionJson(const KnownPorts& known, const KnownPorts::Port& at,
                    const RTT::internal::ConnectionManager::ChannelDescriptor& connection) {
    const bool isOutput = at.port->asOutput() != nullptr;
    const std::string own = at.component + "." + at.name, other = known.partnerOf(connection);
    json made = {{"from", isOutput ? own : other},
                 {"to", isOutput ? other : own},
                 {"type", typeOfPort(*at.port)},
                 {"policy", RTT::internal::policyText(connection.get<2>())},
                 {"samples", nullptr},
                 {"dropped", nullptr}};
    const auto storing = RTT::internal::storageFrom(connection.get<1>(), isOutput);
    const RTT::internal::StorageCore* const storage = storing ? storing->storageCore() : nullptr;
    if (storage && *storage) {
        made["samples"] = storage->store().size();
        made["dropped"] = storage->store().dropped();
    }
    return made;
}

}  // namespace

json graph(const Asked& asked) {
    Visits visits;
    const KnownPorts known({asked.root.gate}, visits);
    json components = json::array(), connections = json::array();
    for (const auto& [name, component] : known.components())
        components.push_back({{"name", name}, {"type", classOf(*component)}, {"state", stateOf(*component)}});
    for (const KnownPorts::Port& at : known.all()) {
        for (const auto& connection : at.port->getManager()->getConnections()) {
            // The output port at the other end has it, too.
            const auto* const peer = connection.get<0>()->peer();
            if (at.port->asInput() && peer && !known.nameOf(peer).empty()) continue;
            connections.push_back(connectionJson(known, at, connection));
        }
    }
    return {{"components", std::move(components)}, {"connections", std::move(connections)}};
}

}  // namespace OCL::live
