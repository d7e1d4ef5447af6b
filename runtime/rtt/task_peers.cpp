// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The peers of components.
#include <rtt/TaskContext.hpp>
#include <rtt/internal/engine/topology.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>

namespace RTT {

namespace {

std::atomic<std::uint32_t> changes{0};

// One lock for all, because a change concerns two components, and both may be destroyed at the same time.
std::mutex& peersMutex() {
    static std::mutex* const mutex = new std::mutex;  // never destroyed: components may be static
    return *mutex;
}
typedef std::lock_guard<std::mutex> Lock;

void disconnectPorts(Service& service) {
    for (base::PortInterface* port : service.getPorts()) port->disconnect();
    for (const std::string& name : service.getProviderNames()) disconnectPorts(*service.getService(name));
}

}  // namespace

bool TaskContext::addPeer(TaskContext* peer, std::string alias) {
    if (!peer) return false;
    if (alias.empty()) alias = peer->getName();
    const Lock lock(peersMutex());
    if (!peers_.emplace(alias, peer).second) return false;
    peer->users_.push_back(this);
    internal::Topology::changed();
    return true;
}

void TaskContext::removePeer(const std::string& name) {
    const Lock lock(peersMutex());
    forgetPeer(name);
}

void TaskContext::removePeer(TaskContext* peer) {
    const Lock lock(peersMutex());
    forgetPeer(peer);
}

void TaskContext::forgetPeer(const std::string& name) {
    const auto found = peers_.find(name);
    if (found == peers_.end()) return;
    TaskContext* const peer = found->second;
    peers_.erase(found);
    internal::Topology::changed();
    // One entry for each name that the peer has here.
    const auto user = std::find(peer->users_.begin(), peer->users_.end(), this);
    if (user != peer->users_.end()) peer->users_.erase(user);
}

void TaskContext::forgetPeer(TaskContext* peer) {
    if (!peer) return;
    const auto named = peers_.find(peer->getName());
    if (named != peers_.end() && named->second == peer) forgetPeer(std::string(named->first));
    if (std::find(peer->users_.begin(), peer->users_.end(), this) == peer->users_.end()) return;
    for (auto entry = peers_.begin(); entry != peers_.end();) {  // it has other names here
        const auto next = std::next(entry);
        if (entry->second == peer) forgetPeer(std::string(entry->first));
        entry = next;
    }
}

void TaskContext::leaveAll() {
    const Lock lock(peersMutex());
    for (TaskContext* user : std::vector<TaskContext*>(users_)) user->forgetPeer(this);
    while (!peers_.empty()) forgetPeer(std::string(peers_.begin()->first));
}

bool TaskContext::connectPeers(TaskContext* peer) {
    if (!peer || hasPeer(peer->getName()) || peer->hasPeer(getName())) return false;
    if (!addPeer(peer)) return false;
    if (peer->addPeer(this)) return true;
    removePeer(peer->getName());  // another thread was faster
    return false;
}

void TaskContext::disconnectPeers(const std::string& name) {
    const Lock lock(peersMutex());
    const auto found = peers_.find(name);
    if (found == peers_.end()) return;
    TaskContext* const peer = found->second;
    forgetPeer(peer);
    peer->forgetPeer(this);
}

void TaskContext::disconnect() {
    disconnectPorts(*provides());
    leaveAll();
}

TaskContext::PeerList TaskContext::getPeerList() const {
    const Lock lock(peersMutex());
    PeerList names;
    for (const auto& entry : peers_) names.push_back(entry.first);
    return names;
}

bool TaskContext::hasPeer(const std::string& name) const {
    const Lock lock(peersMutex());
    return peers_.count(name) != 0;
}

std::uint32_t internal::Topology::changes() noexcept { return RTT::changes.load(std::memory_order_acquire); }

void internal::Topology::changed() noexcept { RTT::changes.fetch_add(1, std::memory_order_acq_rel); }

TaskContext::PeerGates TaskContext::getPeerGates() const {
    const Lock lock(peersMutex());  // while a peer is in the list, it is not destroyed
    PeerGates gates;
    gates.reserve(peers_.size());
    for (const auto& entry : peers_) gates.emplace_back(entry.first, entry.second->engine()->gate());
    return gates;
}

TaskContext* TaskContext::getPeer(const std::string& name) const {
    const Lock lock(peersMutex());
    const auto found = peers_.find(name);
    return found == peers_.end() ? nullptr : found->second;
}

}  // namespace RTT
