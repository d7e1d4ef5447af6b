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

/** The name of the service that runs such a file. */
std::string serviceFor(ScriptPlan::Kind kind, const std::string& file);

/** Has that service of the component run or load a script file; loads the service. False with the reason. */
bool runScript(RTT::TaskContext& component, ScriptPlan::Kind kind, const std::string& file, std::string& error);

}  // namespace OCL::deploy

#endif
