// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "data_flow.hpp"

#include <rtt/DataFlowInterface.hpp>
#include <rtt/Service.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/ConnectionManager.hpp>

#include <map>
#include <sstream>
#include <utility>

namespace OCL::chain {
namespace {

using RTT::base::PortInterface;
using RTT::internal::EngineGate;

struct End {
    std::size_t member;
    std::string port;
};

/** Calls `visit(port, path)` for the ports of a service and of its sub-services. */
template <class Visit>
void eachPort(RTT::Service& service, const std::string& path, Visit&& visit) {
    for (PortInterface* port : service.getPorts()) visit(*port, path + port->getName());
    for (const std::string& name : service.getProviderNames())
        if (name != "this") eachPort(*service.provides(name), path + name + ".", visit);
}

/** The same for a member, if it is still there. */
template <class Visit>
void eachPort(const Peer& member, Visit&& visit) {
    const EngineGate::Visit here(*member.gate);
    auto* const component = dynamic_cast<RTT::TaskContext*>(componentOf(here));
    if (component) eachPort(*component->provides(), "", visit);
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + "\"";
}

}  // namespace

// Ports of other members are compared by address only, because other threads may destroy them.
std::vector<Flow> flowsOf(const std::vector<Peer>& members) {
    std::map<const PortInterface*, End> inputs;
    std::map<const RTT::internal::SharedConnectionBase*, std::vector<End>> readers;
    for (std::size_t i = 0; i != members.size(); ++i)
        eachPort(members[i], [&](PortInterface& port, const std::string& name) {
            if (!port.asInput()) return;
            inputs[&port] = {i, name};
            if (const auto shared = port.getSharedConnection()) readers[shared.get()].push_back({i, name});
        });
    std::vector<Flow> flows;
    for (std::size_t i = 0; i != members.size(); ++i)
        eachPort(members[i], [&](PortInterface& port, const std::string& name) {
            if (!port.asOutput()) return;
            for (const auto& connection : port.getManager()->getConnections()) {
                const auto found = inputs.find(connection.get<0>()->peer());
                if (found != inputs.end()) flows.push_back({i, found->second.member, name, found->second.port});
            }
            const auto shared = port.getSharedConnection();
            if (shared && readers.count(shared.get()))
                for (const End& end : readers.at(shared.get())) flows.push_back({i, end.member, name, end.port});
        });
    return flows;
}

std::string textOf(const Flow& flow, const std::vector<Peer>& members) {
    return members[flow.from].name + "." + flow.output + " → " + members[flow.to].name + "." + flow.input;
}

std::string dotOf(const std::string& chain, const std::vector<Peer>& members) {
    std::ostringstream text;
    text << "digraph " << quoted(chain) << " {\n  rankdir=LR;\n  node [shape=box];\n";
    for (std::size_t i = 0; i != members.size(); ++i)
        text << "  " << quoted(members[i].name) << " [label=" << quoted(std::to_string(i + 1) + " " + members[i].name)
             << "];\n";
    for (std::size_t i = 1; i < members.size(); ++i)
        text << "  " << quoted(members[i - 1].name) << " -> " << quoted(members[i].name) << " [style=bold];\n";
    for (const Flow& flow : flowsOf(members)) {
        const std::string label = flow.output + " → " + flow.input + (flow.isDelayed() ? ", next cycle" : "");
        text << "  " << quoted(members[flow.from].name) << " -> " << quoted(members[flow.to].name)
             << " [constraint=false, " << (flow.isDelayed() ? "style=dashed, color=red, " : "")
             << "label=" << quoted(label) << "];\n";
    }
    text << "}\n";
    return text.str();
}

}  // namespace OCL::chain
