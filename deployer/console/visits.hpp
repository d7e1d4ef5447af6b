// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_VISITS_HPP
#define OROFORGE_CONSOLE_VISITS_HPP

#include <rtt/TaskContext.hpp>
#include <rtt/internal/engine/engine_gate.hpp>

#include <deque>
#include <vector>

namespace OCL::console {

typedef boost::intrusive_ptr<const RTT::internal::EngineGate> Gate;

/** Components that are not destroyed while this exists. Lives on the stack. */
class Visits {
public:
    Visits() = default;
    ~Visits();
    Visits(const Visits&) = delete;
    Visits& operator=(const Visits&) = delete;

    /** Null if it is gone. */
    RTT::TaskContext* enter(const Gate& gate);

private:
    std::deque<RTT::internal::EngineGate::Visit> visits_;
    std::vector<Gate> gates_;  // keep what the visits refer to
};

}  // namespace OCL::console

#endif
