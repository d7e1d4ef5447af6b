// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_SCRIPTS_HPP
#define OROFORGE_DEPLOYMENT_SCRIPTS_HPP

#include "plan.hpp"

#include <string>

namespace RTT {
class TaskContext;
}

namespace OCL::deploy {

/** Has the component's scripting service run or load a script file; loads the service. False with the reason. */
bool runScript(RTT::TaskContext& component, ScriptPlan::Kind kind, const std::string& file, std::string& error);

}  // namespace OCL::deploy

#endif
