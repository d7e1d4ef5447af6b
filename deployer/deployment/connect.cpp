// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "lookup.hpp"
#include "session.hpp"

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/Types.hpp>

namespace OCL::deploy {
namespace {

using RTT::base::InputPortInterface;
using RTT::base::OutputPortInterface;
using RTT::base::PortInterface;

PortInterface* portOf(const Connection::Member& member) {
    return findPort(*member.record->instance, member.plan->port.value);
}

void connectPair(const Connection& connection, const Connection::Member& from, const Connection::Member& to,
                 diag::Sink& sink) {
    PortInterface* const source = portOf(from);
    PortInterface* const target = portOf(to);
    OutputPortInterface* const output = source ? source->asOutput() : nullptr;
    InputPortInterface* const input = target ? target->asInput() : nullptr;
    if (!output || !input || output->connectedTo(input)) return;
    if (output->connectTo(input, connection.policy)) return;
    sink.error(to.plan->port.where, "DEP055",
               "could not connect port '" + from.record->name + "." + from.plan->port.value + "' to '" +
                   to.record->name + "." + to.plan->port.value + "' in connection '" + connection.name + "'")
        .note(from.plan->port.where, "the output port is named here");
}

/** Why the port cannot use this transport; empty if it can. */
std::string missingTransport(const PortInterface& port, int protocol) {
    const RTT::types::TypeInfo* const type = port.getTypeInfo();
    if (!type) return "no typekit knows its type";
    if (type->hasProtocol(protocol) || RTT::types::Types()->unknownType()->hasProtocol(protocol)) return {};
    static const char* const names[] = {"", " (CORBA)", " (message queue)", " (ROS)"};
    const std::string known = protocol < 4 ? names[protocol] : "";
    return "transport " + std::to_string(protocol) + known + " for type " + type->getTypeName() + " is not loaded";
}

}  // namespace

void addPeers(Session& session, int group, diag::Sink& sink) {
    for (ComponentRecord& record : session.records.all) {
        if (record.optionsGroup != group) continue;
        for (const Text& name : record.plan.peers) {
            RTT::TaskContext* peer = session.component(name.value);
            if (!peer)
                sink.error(name.where, "DEP016",
                           "peer '" + name.value + "' of component '" + record.name + "' does not exist");
            else if (record.instance->getPeer(peer->getName()) != peer && !record.instance->addPeer(peer))
                sink.error(name.where, "DEP016",
                           "could not make '" + name.value + "' a peer of component '" + record.name +
                               "': it has another peer of that name");
        }
    }
}

void connectPorts(Session& session, diag::Sink& sink) {
    for (const Connection& connection : session.records.connections())
        for (const Connection::Member& from : connection.members)
            for (const Connection::Member& to : connection.members) connectPair(connection, from, to, sink);
}

void connectSameNames(Session& session, int group, diag::Sink& sink) {
    for (ComponentRecord& record : session.records.all) {
        if (record.optionsGroup != group || !record.plan.autoConnect.value_or(false)) continue;
        for (const std::string& name : record.instance->getPeerList()) {
            RTT::TaskContext* peer = record.instance->getPeer(name);
            const ComponentRecord* other = session.records.find(peer);
            if (!other || !other->plan.autoConnect.value_or(false)) continue;
            // Connecting by names is a convenience: ports that do not fit are reported but are not an error.
            if (!record.instance->connectPorts(peer))
                sink.warning(record.plan.name.where, "DEP056",
                             "AutoConnect: not all ports of the same name of '" + record.name + "' and '" +
                                 other->name + "' could be connected");
        }
    }
}

namespace {

void createStream(const Connection& connection, PortInterface& port, diag::Sink& sink) {
    const Connection::Member& member = connection.members.front();
    const std::string name = member.record->name + "." + member.plan->port.value;
    if (connection.policy.transport == 0)
        sink.warning(member.plan->port.where, "DEP057",
                     "port '" + name + "' is the only one of connection '" + connection.name +
                         "', and the connection names no transport; it stays unconnected");
    else if (const std::string missing = missingTransport(port, connection.policy.transport); !missing.empty())
        sink.warning(member.plan->port.where, "DEP057",
                     "port '" + name + "' gets no stream '" + connection.policy.name_id + "': " + missing);
    else if (port.createStream(connection.policy))
        RTT::log(RTT::Info) << "port '" << name << "' streams to " << connection.policy.name_id << RTT::endlog();
    else
        sink.warning(member.plan->port.where, "DEP057",
                     "could not create stream '" + connection.policy.name_id + "' for port '" + name + "'");
}

}  // namespace

// Those of outputs first, because an input may wait for what its output sends at once.
void createStreams(Session& session, diag::Sink& sink) {
    for (const bool isOutput : {true, false})
        for (const Connection& connection : session.records.connections()) {
            if (connection.members.size() != 1) continue;
            PortInterface* const port = portOf(connection.members.front());
            if (port && !port->connected() && (port->asOutput() != nullptr) == isOutput)
                createStream(connection, *port, sink);
        }
}

}  // namespace OCL::deploy
