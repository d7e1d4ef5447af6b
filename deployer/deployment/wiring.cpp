// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "wiring.hpp"

#include "component_name.hpp"
#include "failure.hpp"
#include "lookup.hpp"

#include <rtt/ConnPolicy.hpp>
#include <rtt/DataFlowInterface.hpp>
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>

namespace OCL::deploy {

using RTT::endlog;
using RTT::log;
using RTT::base::PortInterface;

namespace {

PortInterface* portAt(const Session& session, const std::string& path, const char* toDo) {
    std::string error;
    PortInterface* port = findPort(session, path, error);
    if (!port) failed(std::string("could not ") + toDo + ": " + error);
    return port;
}

bool join(const Session& session, const std::string& one, const std::string& two, const std::string& what,
          bool (RTT::TaskContext::*connect)(RTT::TaskContext*)) {
    const std::string toDo = "connect " + what;
    RTT::TaskContext* first = findComponent(session, one, toDo.c_str());
    RTT::TaskContext* second = findComponent(session, two, toDo.c_str());
    return first && second && doneOr("could not connect all " + what + " of '" + one + "' and '" + two + "'", [&] {
               return (first->*connect)(second);
           });
}

}  // namespace

bool Wiring::connectPeers(const std::string& one, const std::string& two) {
    RTT::TaskContext* first = findComponent(session_, one, "connect peers");
    RTT::TaskContext* second = findComponent(session_, two, "connect peers");
    if (!first || !second) return false;
    // One direction may exist already, as from the deployer to its components.
    const bool hadSecond = first->getPeer(second->getName()) == second;
    {
        const RTT::internal::FailureReport::Pause both;  // one reason is enough
        if (addPeer(one, two) && addPeer(two, one)) return true;
    }
    if (!hadSecond && first->getPeer(second->getName()) == second) first->removePeer(second->getName());
    return failed("could not connect peers '" + one + "' and '" + two + "': one of them has another peer of that name");
}

bool Wiring::addPeer(const std::string& from, const std::string& to, const std::string& alias) {
    RTT::TaskContext* component = findComponent(session_, from, "add a peer");
    RTT::TaskContext* peer = findComponent(session_, to, "add a peer");
    if (!component || !peer) return false;
    const std::string name = alias.empty() ? peer->getName() : alias;
    if (const std::string why = nameFault(name); !why.empty())
        return failed("could not add peer '" + printableName(name) + "' to component '" + from + "': " + why);
    if (component->getPeer(name) == peer) {
        log(RTT::Info) << "'" << from << "' has peer '" << name << "' already" << endlog();
        return true;
    }
    return doneOr("could not add peer '" + name + "' to component '" + component->getName() + "'",
                  [&] { return component->addPeer(peer, name); });
}

bool Wiring::connectPorts(const std::string& one, const std::string& two) {
    return join(session_, one, two, "ports", &RTT::TaskContext::connectPorts);
}

bool Wiring::connect(const std::string& portOne, const std::string& portTwo, const RTT::ConnPolicy& policy) {
    PortInterface* first = portAt(session_, portOne, "connect ports");
    PortInterface* second = portAt(session_, portTwo, "connect ports");
    if (!first || !second) return false;
    if (!doneOr("could not connect port " + portOne + " to " + portTwo,
                [&] { return first->connectTo(second, policy); }))
        return false;
    log(RTT::Info) << "connected port " << portOne << " to " << portTwo << endlog();
    return true;
}

bool Wiring::stream(const std::string& port, const RTT::ConnPolicy& policy) {
    PortInterface* found = portAt(session_, port, "create a stream");
    return found && doneOr("could not create a stream of port " + port, [&] { return found->createStream(policy); });
}

bool Wiring::connectServices(const std::string& one, const std::string& two) {
    return join(session_, one, two, "services", &RTT::TaskContext::connectServices);
}

}  // namespace OCL::deploy
