// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/detail/guarded_call.hpp>

#include <rtt/Logger.hpp>
#include <rtt/base/TaskCore.hpp>

namespace RTT::internal::detail {

std::string nameOf(const base::TaskCore* task) { return task ? task->base::TaskCore::getName() : "GlobalEngine"; }

void threw(const EngineGate::Step& here, const base::TaskCore* task, const char* what, const char* why) {
    const Logger::In in(here.gone() ? "(destroyed)" : nameOf(task).c_str());
    log(Error) << "in " << (here.gone() ? "a component that is no more" : nameOf(task)) << ": " << what
               << " threw: " << why << endlog();
    here.fail();
}

}  // namespace RTT::internal::detail
