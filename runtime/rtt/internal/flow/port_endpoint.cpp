// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/port_endpoint.hpp>

#include <rtt/base/InputPortInterface.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/flow/reclaimer.hpp>

namespace RTT::internal {

bool PortEndpoint::signal() {
    // Most input ports are polled. Relaxed: a port that switches signals on gets those of later samples.
    if (!signals()) return input_.load(std::memory_order_relaxed) != nullptr;
    const Reclaimer::Guard guard;
    base::InputPortInterface* port = input_.load(std::memory_order_acquire);
    if (!port) return false;
    port->signalLater();
    return true;
}

bool PortEndpoint::inputReady(shared_ptr const&) { return true; }

bool PortEndpoint::channelReady(shared_ptr const& caller, ConnPolicy const& policy, ConnID* id) {
    const Reclaimer::Guard guard;
    base::InputPortInterface* port = input_.load(std::memory_order_acquire);
    return port && port->channelReady(caller, policy, id);
}

bool PortEndpoint::disconnect(shared_ptr const& channel, bool) {
    const Reclaimer::Guard guard;  // the port's destructor waits for us
    base::PortInterface* port = port_.load(std::memory_order_acquire);
    return port && channel && port->getManager()->removeChannel(channel.get());
}

void PortEndpoint::disconnect(bool) {
    const Reclaimer::Guard guard;
    if (base::PortInterface* port = port_.load(std::memory_order_acquire)) port->disconnect();
}

// An endpoint keeps no links: they would name only one of its channels.
bool PortEndpoint::connectTo(shared_ptr const& output, bool) { return output && output->connectFrom(this); }

bool PortEndpoint::connectFrom(shared_ptr const&) { return true; }

void PortEndpoint::detach() {
    input_.store(nullptr, std::memory_order_release);
    port_.store(nullptr, std::memory_order_release);
}

}  // namespace RTT::internal
