// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Adds a new connection to the lists of its ports, and decides which connections one port can have at the same time.
#include <rtt/internal/ConnectionManager.hpp>

#include <rtt/base/InputPortInterface.hpp>
#include <rtt/internal/flow/detail/graph_lock.hpp>
#include <rtt/internal/flow/port_endpoint.hpp>
#include <rtt/internal/flow/reclaimer.hpp>

namespace RTT::internal {

using base::ChannelElementBase;
using base::PortInterface;

namespace detail {
std::mutex& GraphLock::mutex() {
    static std::mutex* mutex = new std::mutex;
    return *mutex;
}
}  // namespace detail

namespace {

/** The effect of a buffer policy at one end: for the reader PerOutputPort is an ordinary connection, for the writer
    PerInputPort is. */
int policyAt(bool input, const ConnPolicy& policy) {
    if (policy.buffer_policy == Shared) return Shared;
    const int own = input ? PerInputPort : PerOutputPort;
    return policy.buffer_policy == own ? own : PerConnection;
}

}  // namespace

bool ConnectionManager::mixesBadly(const ConnPolicy& policy) const {
    const bool input = isInput(*port_);
    for (const Connection& c : connections_)
        if (policyAt(input, c.policy) != policyAt(input, policy)) return true;
    return false;
}

ChannelElementBase* ConnectionManager::findShared(const ConnPolicy& policy, ConnPolicy* existing) const {
    const bool input = isInput(*port_);
    if (policyAt(input, policy) == PerConnection || policy.buffer_policy == Shared) return nullptr;
    for (const Connection& c : connections_) {
        if (!c.id->peer() || policyAt(input, c.policy) != policy.buffer_policy) continue;  // streams have their own
        if (existing) *existing = c.policy;
        return c.channel.get();
    }
    return nullptr;
}

ChannelElementBase::shared_ptr ConnectionManager::getSharedStorage() const {
    const detail::GraphLock lock;
    const BufferPolicy own = isInput(*port_) ? PerInputPort : PerOutputPort;
    for (const Connection& c : connections_)
        if (c.shared || (c.id->peer() && c.policy.buffer_policy == own)) return c.channel;
    return nullptr;
}

ChannelElementBase::shared_ptr ConnectionManager::sharedStorage(const ConnPolicy& policy, ConnPolicy* existing) const {
    const detail::GraphLock lock;
    return findShared(policy, existing);
}

ConnectionManager::Obstacle ConnectionManager::join(ConnectionManager& output, ConnectionManager& input,
                                                    const ChannelElementBase::shared_ptr& storage,
                                                    const ConnPolicy& policy, const ChannelElementBase* expected) {
    const detail::GraphLock lock;
    for (const Connection& c : output.connections_)
        if (c.id->peer() == input.port_) return AlreadyConnected;
    if (output.mixesBadly(policy) || input.mixesBadly(policy)) return OtherBufferPolicy;
    ConnectionManager& owner = policy.buffer_policy == PerOutputPort ? output : input;
    if (owner.findShared(policy, nullptr) != expected) return Retry;

    storage->connectFrom(output.port_->endpoint_);
    storage->connectTo(input.port_->endpoint_, policy.mandatory);
    linkTo(*storage, *input.port_, true);
    // The reader first, so that samples of the writer can be read at once.
    input.add({boost::shared_ptr<ConnID>(new LocalConnID(output.port_)), storage, policy, nullptr});
    output.add({boost::shared_ptr<ConnID>(new LocalConnID(input.port_)), storage, policy, nullptr});
    return None;
}

ConnectionManager::Obstacle ConnectionManager::join(const SharedConnectionBase::shared_ptr& connection) {
    const detail::GraphLock lock;
    for (const Connection& c : connections_)
        if (c.shared) return c.shared == connection ? AlreadyConnected : OtherStorage;
    if (mixesBadly(connection->getPolicy())) return OtherBufferPolicy;
    if (isInput(*port_))
        connection->storage()->connectTo(port_->endpoint_);
    else
        connection->storage()->connectFrom(port_->endpoint_);
    linkTo(*connection->storage(), *port_, isInput(*port_));
    connection->members_.push_back({port_, isInput(*port_)});
    add({boost::shared_ptr<ConnID>(new SharedConnID(connection->getName())), connection->storage(),
         connection->getPolicy(), connection});
    return None;
}

}  // namespace RTT::internal
