// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a slave asks of the component and the engine of its master.
#include <rtt/extras/SlaveActivity.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/engine/access_gate.hpp>
#include <rtt/internal/engine/engine_gate.hpp>

namespace RTT::extras {

std::string SlaveActivity::masterName() const {
    const internal::AccessGate::Pass pass(masterGate_);
    auto* const engine = pass ? dynamic_cast<ExecutionEngine*>(master_->getRunner()) : nullptr;
    const base::TaskCore* const component = engine ? engine->getTaskCore() : nullptr;
    return component ? component->getName() : std::string();
}

// The master's engine executes messages in two ways: at the begin of its step, and within one while a component waits.
bool SlaveActivity::awaitsTurn() const {
    const internal::EngineGate::Step* const step = internal::EngineGate::Step::innermost();
    return step && step->first() && getPeriod() > 0;
}

}  // namespace RTT::extras
