// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The operations that connect components: peers, ports, streams, services.
#include "component_name.hpp"
#include "deployment_state.hpp"
#include "failure.hpp"
#include "lookup.hpp"

#include <rtt/ConnPolicy.hpp>
#include <rtt/DataFlowInterface.hpp>
#include <rtt/Logger.hpp>
#include <rtt/ServiceRequester.hpp>

namespace OCL {

using deploy::doneOr;
using deploy::failed;
using RTT::endlog;
using RTT::log;
using RTT::base::PortInterface;

namespace {

PortInterface* findPort(const deploy::Session& session, const std::string& path, const char* toDo) {
    std::string error;
    PortInterface* port = deploy::findPort(session, path, error);
    if (!port) failed(std::string("could not ") + toDo + ": " + error);
    return port;
}

}  // namespace

bool DeploymentComponent::connectPeers(const std::string& one, const std::string& two) {
    RTT::TaskContext* first = deploy::findComponent(impl_->session, one, "connect peers");
    RTT::TaskContext* second = deploy::findComponent(impl_->session, two, "connect peers");
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

bool DeploymentComponent::addPeer(RTT::TaskContext* peer, std::string alias) {
    const std::string name = alias.empty() && peer ? peer->getName() : alias;
    if (const std::string why = deploy::nameFault(name); !why.empty())
        return failed("could not add peer '" + deploy::printableName(name) + "': " + why);
    return TaskContext::addPeer(peer, std::move(alias));
}

bool DeploymentComponent::addPeer(const std::string& from, const std::string& to) {
    return aliasPeer(from, to, std::string());
}

bool DeploymentComponent::aliasPeer(const std::string& from, const std::string& to, const std::string& alias) {
    RTT::TaskContext* component = deploy::findComponent(impl_->session, from, "add a peer");
    RTT::TaskContext* peer = deploy::findComponent(impl_->session, to, "add a peer");
    if (!component || !peer) return false;
    const std::string name = alias.empty() ? peer->getName() : alias;
    if (const std::string why = deploy::nameFault(name); !why.empty())
        return failed("could not add peer '" + deploy::printableName(name) + "' to component '" + from + "': " + why);
    if (component->getPeer(name) == peer) {
        log(RTT::Info) << "'" << from << "' has peer '" << name << "' already" << endlog();
        return true;
    }
    return doneOr("could not add peer '" + name + "' to component '" + component->getName() + "'",
                  [&] { return component->addPeer(peer, name); });
}

bool DeploymentComponent::connectPorts(const std::string& one, const std::string& two) {
    RTT::TaskContext* first = deploy::findComponent(impl_->session, one, "connect ports");
    RTT::TaskContext* second = deploy::findComponent(impl_->session, two, "connect ports");
    return first && second && doneOr("could not connect all ports of '" + one + "' and '" + two + "'", [&] {
               return first->connectPorts(second);
           });
}

bool DeploymentComponent::connectTwoPorts(const std::string& one, const std::string& portOne, const std::string& two,
                                          const std::string& portTwo) {
    return connect(one + "." + portOne, two + "." + portTwo, RTT::ConnPolicy());
}

bool DeploymentComponent::connect(const std::string& portOne, const std::string& portTwo, RTT::ConnPolicy policy) {
    PortInterface* first = findPort(impl_->session, portOne, "connect ports");
    PortInterface* second = findPort(impl_->session, portTwo, "connect ports");
    if (!first || !second) return false;
    if (!doneOr("could not connect port " + portOne + " to " + portTwo,
                [&] { return first->connectTo(second, policy); }))
        return false;
    log(RTT::Info) << "connected port " << portOne << " to " << portTwo << endlog();
    return true;
}

bool DeploymentComponent::stream(const std::string& port, RTT::ConnPolicy policy) {
    PortInterface* found = findPort(impl_->session, port, "create a stream");
    return found && doneOr("could not create a stream of port " + port, [&] { return found->createStream(policy); });
}

bool DeploymentComponent::createStream(const std::string& component, const std::string& port, RTT::ConnPolicy policy) {
    return stream(component + "." + port, policy);
}

bool DeploymentComponent::connectServices(const std::string& one, const std::string& two) {
    RTT::TaskContext* first = deploy::findComponent(impl_->session, one, "connect services");
    RTT::TaskContext* second = deploy::findComponent(impl_->session, two, "connect services");
    return first && second && doneOr("could not connect all services of '" + one + "' and '" + two + "'", [&] {
               return first->connectServices(second);
           });
}

}  // namespace OCL
