// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_actionlib/rtt_actionlib.h>

#include <rtt/Logger.hpp>
#include <rtt/internal/ConnID.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt_roscomm/rostopic.h>

#include <algorithm>
#include <iterator>
#include <typeinfo>
#include <utility>
#include <vector>

namespace rtt_actionlib {

using RTT::Error;
using RTT::endlog;
using RTT::log;
using RTT::base::PortInterface;

namespace {

struct PartName {
    const char* port;
    const char* topic;
    const char* description;
};

constexpr PartName kNames[] = {
    {"_action_goal", "goal", "Goals of an action."},
    {"_action_cancel", "cancel", "Requests to cancel goals of an action."},
    {"_action_status", "status", "The states of all goals of an action, at regular intervals."},
    {"_action_result", "result", "Results of goals of an action."},
    {"_action_feedback", "feedback", "News of the active goals of an action."},
};

bool hasStream(const PortInterface& port, const std::string& topic) {
    const RTT::internal::StreamConnID id(topic);
    for (const auto& one : port.getManager()->getConnections())
        if (one.get<0>() && one.get<0>()->isSameID(id)) return true;
    return false;
}

}  // namespace

std::string actionTopic(const std::string& action_ns, const std::string& name) {
    if (action_ns.empty() || action_ns == "~" || action_ns.back() == '/') return action_ns + name;
    return action_ns + '/' + name;
}

ActionBridge::ActionBridge() = default;

ActionBridge::~ActionBridge() { clear(); }

void ActionBridge::clear() {
    for (int i = 0; i != kParts; ++i) {
        ports_[i] = nullptr;
        owned_[i].reset();
    }
}

const char* ActionBridge::nameOf(Part part) { return kNames[part].port; }

RTT::ConnPolicy ActionBridge::inputPolicy() { return RTT::ConnPolicy::buffer(kWaiting); }

PortInterface& ActionBridge::at(Part part) const {
    if (!ports_[part]) throw std::bad_cast();
    return *ports_[part];
}

bool ActionBridge::own(PortInterface* goal, PortInterface* cancel, PortInterface* status, PortInterface* result,
                       PortInterface* feedback) {
    PortInterface* const all[] = {goal, cancel, status, result, feedback};
    for (int i = 0; i != kParts; ++i) {
        owned_[i].reset(all[i]);
        ports_[i] = all[i];
        all[i]->doc(kNames[i].description);
    }
    return true;
}

bool ActionBridge::setPorts(PortInterface* goal, PortInterface* cancel, PortInterface* status, PortInterface* result,
                            PortInterface* feedback) {
    PortInterface* const all[] = {goal, cancel, status, result, feedback};
    if (!goal || !cancel || !status || !result || !feedback) {
        for (int i = 0; i != kParts; ++i)
            if (!all[i])
                log(Error) << "an action needs a port '" << kNames[i].port
                           << "'; add an action server or client to the component first" << endlog();
        return false;
    }
    const bool isServers = goal->asInput();
    for (int i = 0; i != kParts; ++i) {
        const bool isInput = isServers == (i == kGoal || i == kCancel);
        if (isInput ? all[i]->asInput() != nullptr : all[i]->asOutput() != nullptr) continue;
        log(Error) << "port " << all[i]->getFullName() << " should be an " << (isInput ? "input" : "output")
                   << " port, because " << goal->getFullName() << " is that of an action "
                   << (isServers ? "server" : "client") << endlog();
        return false;
    }
    clear();
    std::copy(std::begin(all), std::end(all), ports_);
    return true;
}

bool ActionBridge::setPortsFromService(const RTT::Service::shared_ptr& service) {
    if (!service) {
        log(Error) << "the ports of an action cannot be taken from a service that does not exist" << endlog();
        return false;
    }
    PortInterface* found[kParts];
    for (int i = 0; i != kParts; ++i) found[i] = service->getPort(kNames[i].port);
    return setPorts(found[kGoal], found[kCancel], found[kStatus], found[kResult], found[kFeedback]);
}

bool ActionBridge::addPortsTo(const RTT::Service::shared_ptr& service, const InputCallback& arrived) {
    if (!service || !isValid()) {
        log(Error) << "the ports of an action " << (service ? "were not created" : "need a service to be added to")
                   << endlog();
        return false;
    }
    for (const PartName& name : kNames) {
        if (!service->getPort(name.port)) continue;
        log(Error) << "service '" << service->getName() << "' has a port '" << name.port
                   << "' already; put the second action into a service of its own" << endlog();
        return false;
    }
    for (PortInterface* port : ports_) {
        if (RTT::base::InputPortInterface* const input = port->asInput())
            service->addEventPort(*input, arrived);
        else
            service->addPort(*port);
    }
    return true;
}

bool ActionBridge::isServer() const {
    return ports_[kGoal] && ports_[kGoal]->asInput();
}

bool ActionBridge::isClient() const {
    return ports_[kGoal] && ports_[kGoal]->asOutput();
}

bool ActionBridge::createStream(const std::string& action_ns) {
    return connect(action_ns, rtt_roscomm::topicBuffer("", kWaiting), true);
}

bool ActionBridge::createStream(const std::string& action_ns, const RTT::ConnPolicy& policy) {
    return connect(action_ns, policy, false);
}

bool ActionBridge::connect(const std::string& action_ns, const RTT::ConnPolicy& policy, bool keepsStatus) {
    if (!isValid()) {
        log(Error) << "action '" << action_ns << "' has no ports to connect; create or set them first" << endlog();
        return false;
    }
    std::vector<std::pair<PortInterface*, std::string>> made;
    for (int i = 0; i != kParts; ++i) {
        RTT::ConnPolicy own = policy;
        own.transport = ORO_ROS_PROTOCOL_ID;
        own.name_id = actionTopic(action_ns, kNames[i].topic);
        if (keepsStatus && i == kStatus) own.init = ports_[i]->asOutput() != nullptr;
        if (hasStream(*ports_[i], own.name_id)) continue;
        if (ports_[i]->createStream(own)) {
            made.emplace_back(ports_[i], own.name_id);
            continue;
        }
        log(Error) << "action '" << action_ns << "' was not connected: port " << ports_[i]->getFullName()
                   << " has no stream" << endlog();
        for (const auto& [port, topic] : made) {
            RTT::internal::StreamConnID id(topic);
            (void)port->removeConnection(&id);
        }
        return false;
    }
    return true;
}

bool ActionBridge::allConnected() const {
    for (const PortInterface* port : ports_)
        if (!port || !port->connected()) return false;
    return true;
}

bool ActionBridge::anyConnected() const {
    for (const PortInterface* port : ports_)
        if (port && port->connected()) return true;
    return false;
}

RTT::InputPort<actionlib_msgs::GoalID>& ActionBridge::cancelInput() {
    return as<RTT::InputPort<actionlib_msgs::GoalID>>(kCancel);
}

RTT::OutputPort<actionlib_msgs::GoalID>& ActionBridge::cancelOutput() {
    return as<RTT::OutputPort<actionlib_msgs::GoalID>>(kCancel);
}

RTT::InputPort<actionlib_msgs::GoalStatusArray>& ActionBridge::statusInput() {
    return as<RTT::InputPort<actionlib_msgs::GoalStatusArray>>(kStatus);
}

RTT::OutputPort<actionlib_msgs::GoalStatusArray>& ActionBridge::statusOutput() {
    return as<RTT::OutputPort<actionlib_msgs::GoalStatusArray>>(kStatus);
}

}  // namespace rtt_actionlib
