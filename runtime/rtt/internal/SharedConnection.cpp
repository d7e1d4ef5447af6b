// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/SharedConnection.hpp>

#include <rtt/base/PortInterface.hpp>
#include <rtt/types/Schema.hpp>

#include <algorithm>
#include <mutex>

namespace RTT::internal {

namespace {
std::mutex& repositoryMutex() {
    static std::mutex* mutex = new std::mutex;
    return *mutex;
}
}  // namespace

SharedConnectionBase::SharedConnectionBase(const std::string& name, base::ChannelElementBase::shared_ptr storage,
                                           const ConnPolicy& policy, const base::PortInterface& first)
    : storage_(storage), policy_(policy), ops_(*first.sampleOps()), schema_(*first.sampleSchema()) {
    policy_.name_id = name;
}

SharedConnectionBase::~SharedConnectionBase() = default;

std::string SharedConnectionBase::difference(const base::PortInterface& port) const {
    return types::schemaDifference(schema_, *port.sampleSchema(), "in the connection",
                                   "in the plugin of " + port.getFullName());
}

void SharedConnectionBase::removeMember(const base::PortInterface& port) {
    const auto same = [&port](const Member& m) { return m.port == &port; };
    members_.erase(std::remove_if(members_.begin(), members_.end(), same), members_.end());
}

void SharedConnectionBase::deref() {
    if (references_.fetch_sub(1, std::memory_order_acq_rel) == 1) SharedConnectionRepository::Instance().forget(*this);
}

// Relaxed: the repository's lock, which callers hold, orders the content; the count must only not leave 0.
SharedConnectionBase::shared_ptr SharedConnectionBase::revive() {
    int count = references_.load(std::memory_order_relaxed);
    while (count != 0)
        if (references_.compare_exchange_weak(count, count + 1, std::memory_order_relaxed))
            return shared_ptr(this, false);
    return nullptr;
}

SharedConnectionRepository& SharedConnectionRepository::Instance() {
    static SharedConnectionRepository* repository = new SharedConnectionRepository;
    return *repository;
}

SharedConnectionBase::shared_ptr SharedConnectionRepository::get(const std::string& name) {
    const std::lock_guard<std::mutex> lock(repositoryMutex());
    const auto found = connections_.find(name);
    return found == connections_.end() ? nullptr : found->second->revive();
}

SharedConnectionBase::shared_ptr SharedConnectionRepository::add(SharedConnectionBase::shared_ptr connection) {
    const std::lock_guard<std::mutex> lock(repositoryMutex());
    SharedConnectionBase*& entry = connections_[connection->getName()];
    SharedConnectionBase::shared_ptr existing = entry ? entry->revive() : nullptr;
    if (existing) return existing;
    entry = connection.get();
    return connection;
}

std::string SharedConnectionRepository::uniqueName() {
    const std::lock_guard<std::mutex> lock(repositoryMutex());
    std::string name;
    do name = "shared_connection_" + std::to_string(++counter_);
    while (connections_.count(name));
    return name;
}

/** The last reference is gone, and revive() gives out no more. */
void SharedConnectionRepository::forget(SharedConnectionBase& connection) {
    {
        const std::lock_guard<std::mutex> lock(repositoryMutex());
        const auto found = connections_.find(connection.getName());
        if (found != connections_.end() && found->second == &connection) connections_.erase(found);
    }
    delete &connection;
}

}  // namespace RTT::internal
