// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "graph.hpp"

#include "dot_text.hpp"
#include "foreseen_graph.hpp"

#include <rtt/DataFlowInterface.hpp>
#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/flow/connection_facts.hpp>
#include <rtt/internal/flow/sample_type_name.hpp>

#include <map>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>
#include <vector>

namespace OCL::deploy {
namespace {

using RTT::base::OutputPortInterface;
using RTT::base::PortInterface;

class Graph {
public:
    explicit Graph(const Session& session) : session_(session) {}

    std::string text() {
        text_ << "digraph " << dotQuoted(session_.deployer->getName()) << " {\n  rankdir=LR;\n  node [shape=box];\n";
        findNodes();
        for (const auto& [name, component] : nodes_) addNode(*component, name);
        for (const auto& [name, component] : nodes_) addEdges(*component, name);
        for (const Plan& plan : session_.planned)
            for (const ComponentPlan& component : plan.components) addPlanned(component);
        text_ << foreseenGraphOf(session_);
        for (const std::string& connection : connections_)
            text_ << "  " << dotQuoted("connection " + connection) << " [shape=ellipse, label=" << dotQuoted(connection)
                  << "];\n";
        text_ << "}\n";
        return text_.str();
    }

private:
    /** Finds a node for each component, named after it if the deployer uses that name. */
    void findNodes() {
        for (const std::string& name : session_.deployer->getPeerList()) {
            RTT::TaskContext* const component = session_.deployer->getPeer(name);
            std::string& node = nodeOf_[component];
            if (node.empty() || name == component->getName()) node = name;
        }
        for (const std::string& name : session_.deployer->getPeerList()) {
            RTT::TaskContext* const component = session_.deployer->getPeer(name);
            if (nodeOf_.at(component) == name) nodes_.emplace_back(name, component);
        }
    }

    void addNode(RTT::TaskContext& component, const std::string& name) {
        std::string type;
        for (const ComponentRecord& record : session_.records.all)
            if (record.instance == &component) type = record.plan.type.value;
        text_ << "  " << dotQuoted(name) << " [label=" << label(name, type) << "];\n";
    }

    /** The node of a component, whatever name its peers use. */
    std::string nodeOf(const RTT::TaskContext& component) const {
        const auto known = nodeOf_.find(&component);
        return known == nodeOf_.end() ? component.getName() : known->second;
    }

    static std::string label(const std::string& name, const std::string& type) {
        return type.empty() || type == "PropertyBag" ? dotQuoted(name) : dotTwoLines(name, type);
    }

    void addEdges(RTT::TaskContext& component, const std::string& node) {
        addConnections(node, *component.provides(), "");
        for (const std::string& name : component.getPeerList()) {
            const RTT::TaskContext& peer = *component.getPeer(name);
            addPeer(node, nodeOf(peer), name == peer.getName() ? "peer" : "peer " + name);
        }
    }

    void addPeer(const std::string& from, const std::string& to, const std::string& name) {
        text_ << "  " << dotQuoted(from) << " -> " << dotQuoted(to) << " [style=dashed, label=" << dotQuoted(name)
              << "];\n";
    }

    /** Adds the connections of the output ports of a service and of its sub-services. */
    void addConnections(const std::string& component, RTT::Service& service, const std::string& path) {
        for (PortInterface* port : service.getPorts())
            if (auto* output = port->asOutput()) addConnections(component, *output, path);
        for (const std::string& name : service.getProviderNames())
            if (name != "this") addConnections(component, *service.provides(name), path + name + ".");
    }

    void addConnections(const std::string& component, OutputPortInterface& output, const std::string& path) {
        for (const auto& connection : output.getManager()->getConnections()) {
            const PortInterface* const peer = connection.get<0>()->peer();
            const RTT::DataFlowInterface* const owner = peer ? peer->getInterface() : nullptr;
            const std::string end = owner && owner->getOwner() ? dotQuoted(nodeOf(*owner->getOwner()))
                                                               : dotQuoted(connection.get<0>()->toString());
            std::string text = path + output.getName();
            if (peer) text += " → " + peer->getName();
            const std::string data =
                RTT::internal::sampleTypeName(output) + ", " + RTT::internal::policyText(connection.get<2>());
            text_ << "  " << dotQuoted(component) << " -> " << end << " [label=" << dotTwoLines(text, data) << "];\n";
        }
    }

    void addPlanned(const ComponentPlan& component) {
        const std::string& name = component.name.value;
        if (planned_.insert(name).second)  // further structs only add options
            text_ << "  " << dotQuoted(name) << " [label=" << label(name, component.type.value) << "];\n";
        for (const PortPlan& port : component.ports) {
            connections_.insert(port.connection.value);
            if (!ends_.emplace(name, port.port.value, port.connection.value).second) continue;
            text_ << "  " << dotQuoted(name) << " -> " << dotQuoted("connection " + port.connection.value)
                  << " [dir=none, label=" << dotQuoted(port.port.value) << "];\n";
        }
        for (const Text& peer : component.peers)
            if (peers_.emplace(name, peer.value).second) addPeer(name, peer.value, "peer");
    }

    const Session& session_;
    std::ostringstream text_;
    std::vector<std::pair<std::string, RTT::TaskContext*>> nodes_;  // of existing components
    std::map<const RTT::TaskContext*, std::string> nodeOf_;
    std::set<std::string> planned_, connections_;                       // of plans
    std::set<std::tuple<std::string, std::string, std::string>> ends_;  // component, port, connection
    std::set<std::pair<std::string, std::string>> peers_;
};

}  // namespace

std::string graphOf(const Session& session) { return Graph(session).text(); }

}  // namespace OCL::deploy
