// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/ConnectionManager.hpp>

#include <rtt/base/InputPortInterface.hpp>
#include <rtt/internal/flow/channel_array.hpp>
#include <rtt/internal/flow/connection_facts.hpp>
#include <rtt/internal/flow/detail/graph_lock.hpp>
#include <rtt/internal/flow/port_endpoint.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/internal/flow/storage_core.hpp>

#include <algorithm>

namespace RTT::internal {

using base::ChannelElementBase;
using base::PortInterface;
using detail::GraphLock;

ConnectionManager::~ConnectionManager() = default;

bool ConnectionManager::isInput(const PortInterface& port) { return port.asInput() != nullptr; }

/** Ports of the same direction in one shared connection are not connected with each other. */
bool ConnectionManager::leadsTo(const Connection& connection, const PortInterface& port) const {
    if (connection.id->peer() == &port || connection.id->partner() == &port) return true;
    return connection.shared && isInput(port) != isOfInput_ && port.manager_->uses(connection.channel.get());
}

ConnectionManager::Connections ConnectionManager::getConnections() const {
    const GraphLock lock;
    Connections result;
    for (const Connection& c : connections_) result.push_back(ChannelDescriptor(c.id, c.channel, c.policy));
    return result;
}

bool ConnectionManager::connected() const { return port_->connected(); }

bool ConnectionManager::connectedTo(PortInterface* port) const {
    if (!port) return false;
    const GraphLock lock;
    return std::any_of(connections_.begin(), connections_.end(),
                       [&](const Connection& c) { return leadsTo(c, *port); });
}

SharedConnectionBase::shared_ptr ConnectionManager::getSharedConnection() const {
    const GraphLock lock;
    for (const Connection& c : connections_)
        if (c.shared) return c.shared;
    return nullptr;
}

void ConnectionManager::addConnection(ConnID* id, ChannelElementBase::shared_ptr channel, const ConnPolicy& policy) {
    {
        const GraphLock lock;
        add({boost::shared_ptr<ConnID>(id), channel, policy, nullptr});
    }
    Reclaimer::collect();
}

bool ConnectionManager::removeConnection(const ConnID* id) {
    return id && removeIf([id](const Connection& c) { return c.id->isSameID(*id); });
}

bool ConnectionManager::removeChannel(const ChannelElementBase* channel) {
    return removeIf([channel](const Connection& c) { return c.channel.get() == channel; });
}

bool ConnectionManager::disconnect(PortInterface* port) {
    if (!port) return false;
    return removeIf([this, port](const Connection& c) { return leadsTo(c, *port); });
}

void ConnectionManager::disconnect() {
    removeIf([](const Connection&) { return true; });
}

template <class Which>
bool ConnectionManager::removeIf(Which which) {
    List gone, partners;
    bool towardsReader = false;
    {
        const GraphLock lock;
        towardsReader = !isOfInput_;
        const auto end = std::stable_partition(connections_.begin(), connections_.end(),
                                               [&](const Connection& c) { return !which(c); });
        if (end == connections_.end()) return false;
        gone.assign(std::make_move_iterator(end), std::make_move_iterator(connections_.end()));
        connections_.erase(end, connections_.end());
        publish();
        for (const Connection& c : gone) unlink(c);
        takeFromPartners(gone, partners);
    }
    // Transports end their part without the lock: towards the reader from an output port, and vice versa.
    for (const Connection& c : gone)
        if (!c.id->peer() && !c.shared) c.channel->disconnect(nullptr, towardsReader);
    for (const Connection& c : partners) c.channel->disconnect(nullptr, !towardsReader);
    gone.clear();
    partners.clear();
    Reclaimer::collect();
    return true;
}

/** `connection` has left our list. Removes it from the peer's, and its storage from ports that no longer use it. */
void ConnectionManager::unlink(const Connection& connection) {
    PortInterface* const peer = connection.id->peer();
    if (!peer && !connection.shared) return;
    ChannelElementBase* const channel = connection.channel.get();
    if (peer) {
        List& theirs = peer->manager_->connections_;
        const auto same = [&](const Connection& c) { return c.id->peer() == port_ && c.channel.get() == channel; };
        theirs.erase(std::remove_if(theirs.begin(), theirs.end(), same), theirs.end());
        peer->manager_->publish();
    }
    StorageCore* const core = channel->storageCore();
    for (PortInterface* port : {port_, peer}) {
        if (!port || port->manager_->uses(channel)) continue;
        ChannelElementBase* const end = port->endpoint_.get();
        if (core && core->hasManyReaders()) core->removeReader(end);
        ChannelElementBase::dropLink(channel->output_, end);
        ChannelElementBase::dropLink(channel->input_, end);
        if (connection.shared) connection.shared->removeMember(*port);
    }
    if (connection.shared)
        for (const SharedConnectionBase::Member& m : connection.shared->members_) linkTo(*channel, *m.port, m.input);
    // Others are not asked for their direction, because they may be under destruction.
    const bool input = isOfInput_;
    for (const Connection& c : connections_)
        if (c.channel.get() == channel && c.id->peer()) linkTo(*channel, *c.id->peer(), !input);
    if (!peer) return;
    for (const Connection& c : peer->manager_->connections_)
        if (c.channel.get() == channel && c.id->peer()) linkTo(*channel, *c.id->peer(), input);
}

/** The other ends of out-of-band connections, which leave their ports' lists, too. */
void ConnectionManager::takeFromPartners(const List& gone, List& theirs) {
    for (const Connection& mine : gone) {
        PortInterface* const partner = mine.id->partner();
        if (!partner) continue;
        List& all = partner->manager_->connections_;
        const auto end = std::stable_partition(all.begin(), all.end(), [&](const Connection& c) {
            return c.id->partner() != port_ || !c.id->isSameID(*mine.id);
        });
        theirs.insert(theirs.end(), std::make_move_iterator(end), std::make_move_iterator(all.end()));
        all.erase(end, all.end());
        partner->manager_->publish();
    }
}

/** Keeps a port at both ends of a storage, whichever of its ports have left, for code that follows the links. */
void ConnectionManager::linkTo(ChannelElementBase& storage, const PortInterface& port, bool input) {
    std::atomic<ChannelElementBase*>& link = input ? storage.output_ : storage.input_;
    if (!link.load(std::memory_order_acquire)) ChannelElementBase::exchangeLink(link, port.endpoint_.get());
}

bool ConnectionManager::uses(const ChannelElementBase* channel) const {
    return std::any_of(connections_.begin(), connections_.end(),
                       [channel](const Connection& c) { return c.channel.get() == channel; });
}

void ConnectionManager::add(const Connection& connection) {
    isOfInput_ = isInput(*port_);
    connections_.push_back(connection);
    publish();
}

/** Shows the current list to writers or readers. A storage shared by several connections appears once. */
void ConnectionManager::publish() {
    std::vector<ChannelArray::Entry> entries;
    for (const Connection& c : connections_) {
        const auto same = [&](const ChannelArray::Entry& e) { return e.channel == c.channel.get(); };
        const auto found = std::find_if(entries.begin(), entries.end(), same);
        if (found == entries.end())
            entries.push_back({c.channel.get(), c.policy.mandatory});
        else
            found->mandatory = found->mandatory || c.policy.mandatory;
    }
    // Release: a thread that loads the array sees its entries and the complete channels.
    ChannelArray::retire(
        port_->channels_.exchange(ChannelArray::make(entries.data(), entries.size()), std::memory_order_acq_rel));
    countConnectionChange();
}

}  // namespace RTT::internal
