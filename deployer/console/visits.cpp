// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "visits.hpp"

#include <rtt/ExecutionEngine.hpp>

namespace OCL::console {

Visits::~Visits() {
    while (!visits_.empty()) visits_.pop_back();
}

RTT::TaskContext* Visits::enter(const Gate& gate) {
    gates_.push_back(gate);
    visits_.emplace_back(*gate);
    RTT::ExecutionEngine* const engine = visits_.back().engine();
    return engine ? dynamic_cast<RTT::TaskContext*>(engine->getTaskCore()) : nullptr;
}

}  // namespace OCL::console
