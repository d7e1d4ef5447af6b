// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/connection_facts.hpp>

#include <rtt/ConnPolicy.hpp>
#include <rtt/base/PortInterface.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/flow/storage_core.hpp>

#include <atomic>

namespace RTT::internal {

using base::ChannelElementBase;

namespace {
std::atomic<std::uint64_t> changes{0};
}

std::uint64_t connectionChanges() { return changes.load(std::memory_order_acquire); }
void countConnectionChange() { changes.fetch_add(1, std::memory_order_acq_rel); }

std::string policyText(const ConnPolicy& policy) {
    switch (policy.type) {
        case ConnPolicy::DATA: return "data";
        case ConnPolicy::BUFFER: return "buffer " + std::to_string(policy.size);
        case ConnPolicy::CIRCULAR_BUFFER: return "circular buffer " + std::to_string(policy.size);
        default: return "unbuffered";
    }
}

ChannelElementBase::shared_ptr storageFrom(ChannelElementBase::shared_ptr element, bool towardsReader) {
    while (element && !element->storageCore()) element = towardsReader ? element->getOutput() : element->getInput();
    return element;
}

std::vector<ChannelElementBase::shared_ptr> storagesOf(const base::PortInterface& input) {
    std::vector<ChannelElementBase::shared_ptr> found;
    for (const auto& connection : input.getManager()->getConnections()) {
        const ChannelElementBase::shared_ptr at = storageFrom(connection.get<1>(), false);
        if (at) found.push_back(at);
    }
    return found;
}

std::uint64_t droppedIn(const std::vector<ChannelElementBase::shared_ptr>& storages) {
    std::uint64_t sum = 0;
    for (const ChannelElementBase::shared_ptr& at : storages) sum += at->storageCore()->store().dropped();
    return sum;
}

std::uint64_t droppedSamples(const base::PortInterface& input) { return droppedIn(storagesOf(input)); }

}  // namespace RTT::internal
