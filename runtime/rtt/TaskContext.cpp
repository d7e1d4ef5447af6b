// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/TaskContext.hpp>

#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/ServiceLoader.hpp>

#include <algorithm>

namespace RTT {

TaskContext::TaskContext(const std::string& name, TaskState initial_state)
    : TaskCore(initial_state),
      service_(boost::make_shared<Service>(name)),
      requester_(boost::make_shared<ServiceRequester>(name, this)) {
    service_->setOwner(this);
    service_->doc("The interface of this TaskContext.");
    addStandardInterface();
    setActivity(nullptr);
}

TaskContext::~TaskContext() {
    if (activity_) activity_->stop();
    // Others may hold these pointers longer than the component lives.
    service_->setOwner(nullptr);
    requester_->setOwner(nullptr);
    clear();
    providers_.clear();
    for (TaskContext* user : std::vector<TaskContext*>(users_)) user->removePeer(this);
    while (!peers_.empty()) removePeer(peers_.begin()->first);
    if (activity_) activity_->run(nullptr);
    activity_.reset();
}

const std::string& TaskContext::getName() const { return service_->getName(); }

bool TaskContext::setActivity(base::ActivityInterface* new_act) {
    base::ActivityInterface::shared_ptr owned(new_act);
    if (isRunning()) {
        log(Error) << getName() << ": the activity cannot be changed while the component is running" << endlog();
        return false;
    }
    if (engine()->isStepping()) {
        log(Error) << getName() << ": the activity cannot be changed by the thread of the present one" << endlog();
        return false;
    }
    if (!owned) owned.reset(new Activity(engine(), getName()));
    owned->stop();
    if (activity_) {
        activity_->stop();
        activity_->run(nullptr);
    }
    activity_ = owned;
    activity_->run(engine());
    activity_->start();
    return true;
}

void TaskContext::forceActivity(base::ActivityInterface* new_act) {
    if (!new_act) return;
    new_act->stop();
    if (activity_) {
        activity_->stop();
        activity_->run(nullptr);
    }
    activity_.reset(new_act);
    activity_->run(engine());
    activity_->start();
}

base::ActivityInterface* TaskContext::getActivity() { return activity_.get(); }

bool TaskContext::start() { return !isRunning() && TaskCore::start(); }
bool TaskContext::stop() { return TaskCore::stop(); }
bool TaskContext::ready() { return true; }

void TaskContext::clear() {
    service_->clear();
    requester_->clear();
}

bool TaskContext::addPeer(TaskContext* peer, std::string alias) {
    if (!peer) return false;
    if (alias.empty()) alias = peer->getName();
    if (!peers_.emplace(alias, peer).second) return false;
    peer->users_.push_back(this);
    return true;
}

void TaskContext::removePeer(const std::string& name) {
    const auto found = peers_.find(name);
    if (found == peers_.end()) return;
    TaskContext* const peer = found->second;
    peers_.erase(found);
    // One entry for each name that the peer has here.
    const auto user = std::find(peer->users_.begin(), peer->users_.end(), this);
    if (user != peer->users_.end()) peer->users_.erase(user);
}

void TaskContext::removePeer(TaskContext* peer) {
    for (auto entry = peers_.begin(); entry != peers_.end();) {
        const auto next = std::next(entry);
        if (entry->second == peer) removePeer(std::string(entry->first));
        entry = next;
    }
}

bool TaskContext::connectPeers(TaskContext* peer) {
    if (!peer || hasPeer(peer->getName()) || peer->hasPeer(getName())) return false;
    return addPeer(peer) && peer->addPeer(this);
}

void TaskContext::disconnectPeers(const std::string& name) {
    if (TaskContext* peer = getPeer(name)) {
        removePeer(peer);
        peer->removePeer(this);
    }
}

void TaskContext::disconnect() {
    for (base::PortInterface* port : ports()->getPorts()) port->disconnect();
    for (TaskContext* user : std::vector<TaskContext*>(users_)) user->removePeer(this);
    while (!peers_.empty()) removePeer(peers_.begin()->first);
}

TaskContext::PeerList TaskContext::getPeerList() const {
    PeerList names;
    for (const auto& entry : peers_) names.push_back(entry.first);
    return names;
}

bool TaskContext::hasPeer(const std::string& name) const { return peers_.count(name) != 0; }

TaskContext* TaskContext::getPeer(const std::string& name) const {
    const auto found = peers_.find(name);
    return found == peers_.end() ? nullptr : found->second;
}

bool TaskContext::connectPorts(TaskContext* peer) {
    if (!peer) return false;
    bool success = true;
    for (base::PortInterface* mine : ports()->getPorts()) {
        base::PortInterface* theirs = peer->ports()->getPort(mine->getName());
        if (!theirs) continue;
        const bool mineReads = dynamic_cast<base::InputPortInterface*>(mine) != nullptr;
        const bool theirsReads = dynamic_cast<base::InputPortInterface*>(theirs) != nullptr;
        if (mineReads == theirsReads) {
            log(Debug) << "ports '" << mine->getName() << "' of " << getName() << " and " << peer->getName()
                       << " have the same direction and are not connected" << endlog();
            continue;
        }
        if (!mine->connectTo(theirs)) success = false;
    }
    return success;
}

bool TaskContext::connectServices(TaskContext* peer) {
    if (!peer) return false;
    bool success = true;
    TaskContext* const pairs[][2] = {{this, peer}, {peer, this}};
    for (const auto& pair : pairs) {
        const ServiceRequester::shared_ptr root = pair[0]->requires_();
        if (!root->ready()) root->connectTo(pair[1]->provides());
        for (const std::string& name : root->getRequesterNames()) {
            const ServiceRequester::shared_ptr requester = root->requires_(name);
            if (requester->ready() || !pair[1]->provides()->hasService(name)) continue;
            if (!requester->connectTo(pair[1]->provides(name))) success = false;
        }
    }
    return success;
}

bool TaskContext::loadService(const std::string& name) {
    return service_->hasService(name) || internal::loadServicePlugin(name, this);
}

bool TaskContext::dataOnPortHook(base::PortInterface*) { return isRunning(); }

void TaskContext::dataOnPort(base::PortInterface* port) {
    // The component may be started, and stopped, while the hook decides.
    const unsigned starts = mStartCounter;
    const bool running = isRunning();
    if (!dataOnPortHook(port) || !port_callbacks_.announce(port, running || mStartCounter != starts)) return;
    if (!engine()->process(port)) port_callbacks_.withdraw(port);
}

void TaskContext::dataOnPortCallback(base::PortInterface* port) {
    // stop() changes the target first and then waits for the step in progress, so every later step sees the change.
    port_callbacks_.call(port, getTaskState() >= Running && getTargetState() >= Running);
}

void TaskContext::setDataOnPortCallback(base::InputPortInterface* port, const SlotFunction& callback) {
    port_callbacks_.set(port, callback ? callback : SlotFunction([this](base::PortInterface*) { trigger(); }));
}

void TaskContext::dataOnPortRemoved(base::PortInterface* port) { port_callbacks_.remove(port); }

}  // namespace RTT
