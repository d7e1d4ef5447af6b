// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "life.hpp"

#include "failure.hpp"

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>

namespace OCL::lua {

Life::Life(RTT::TaskContext& component) : gate_(component.engine()->gate()) {}

Life::Life(const RTT::Service& service) {
    if (RTT::TaskContext* const owner = service.getOwner()) gate_ = owner->engine()->gate();
}

void Life::fail(const char* what) { throw Failure(std::string("the component of this ") + what + " was destroyed"); }

}  // namespace OCL::lua
