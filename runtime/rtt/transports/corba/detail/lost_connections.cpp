// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/lost_connections.hpp>

#include <rtt/DataFlowInterface.hpp>
#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/engine/engine_gate.hpp>

#include <string>
#include <utility>

namespace RTT::corba::detail {

namespace {

constexpr int kTries = 10;  // its process may still be adding ports

/** Before its end, another process disconnects its ports. */
constexpr std::chrono::seconds kEnd{10};

}  // namespace

LostConnections::Ended LostConnections::remember(const base::PortInterface& port, const ConnPolicy& policy) {
    Service* const service = port.getInterface() ? port.getInterface()->getService() : nullptr;
    TaskContext* const owner = service ? service->getOwner() : nullptr;
    if (!owner) return {};
    // The component may be destroyed by the time it is needed.
    const boost::intrusive_ptr<const internal::EngineGate> gate = owner->engine()->gate();
    const boost::weak_ptr<Service> provided = service->shared_from_this();
    const auto withPort = [gate, provided,
                           name = port.getName()](const std::function<void(base::PortInterface&)>& use) {
        const internal::EngineGate::Visit visit(*gate);
        const boost::shared_ptr<Service> present = visit.engine() ? provided.lock() : nullptr;
        base::PortInterface* const found = present ? present->getPort(name) : nullptr;
        if (found) use(*found);
        return found != nullptr;
    };
    return [own = weak_from_this(), withPort, policy](bool isGone) {
        const std::shared_ptr<LostConnections> present = own.lock();
        if (!present) return;
        const std::lock_guard<std::mutex> lock(present->mutex_);
        present->all_.push_back({withPort, policy, isGone, std::chrono::steady_clock::now(), 0});
    };
}

void LostConnections::ended() {
    const auto limit = std::chrono::steady_clock::now() - kEnd;
    const std::lock_guard<std::mutex> lock(mutex_);
    for (Lost& one : all_) one.isGone = one.isGone || one.since > limit;
}

std::vector<LostConnections::Lost> LostConnections::take() {
    const auto limit = std::chrono::steady_clock::now() - kEnd;
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<Lost> taken, kept;
    for (Lost& one : all_)
        if (one.isGone || one.since > limit) (one.isGone ? taken : kept).push_back(std::move(one));
    all_.swap(kept);
    return taken;
}

void LostConnections::restore(const std::function<bool(base::PortInterface& port, const ConnPolicy& policy)>& connect) {
    for (Lost& one : take()) {
        bool isDone = false;
        const bool exists = one.withPort([&](base::PortInterface& port) { isDone = connect(port, one.policy); });
        if (!exists || isDone || ++one.tries == kTries) continue;
        const std::lock_guard<std::mutex> lock(mutex_);
        all_.push_back(std::move(one));
    }
}

}  // namespace RTT::corba::detail
