// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/execute/peers.hpp>

#include <rtt/TaskContext.hpp>

#include <algorithm>

namespace RTT::scripting::detail {

void Peers::add(const TaskContext& component) {
    const auto& gate = component.engine()->gate();
    const auto same = [&gate](const Peer& peer) { return peer.gate == gate; };
    if (std::none_of(peers_.begin(), peers_.end(), same)) peers_.push_back({component.getName(), gate});
}

}  // namespace RTT::scripting::detail
