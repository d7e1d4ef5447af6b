// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_SCRIPTS_HPP
#define OROFORGE_DEPLOYMENT_SCRIPTS_HPP

#include "records.hpp"

#include <string>

namespace OCL::deploy {

/** The name of the service that runs such a file. */
std::string serviceFor(ScriptPlan::Kind kind, const std::string& file);

bool isLua(const std::string& file);
/** Has the component's service Lua compile the file. What is wrong; empty if it can be executed. */
std::string luaFault(RTT::TaskContext& component, const std::string& file);

/** Runs or loads a script file by that service of the component, which is loaded first. False with the reason, which is
    empty if it is in the log. */
bool runScript(RTT::TaskContext& component, ScriptPlan::Kind kind, const std::string& file, std::string& error);

/** The same for a script that a deployment file names. If it ran before, first unloads the programs and state machines
    that it loaded, so that the component has them only once. */
bool runScript(ComponentRecord& record, const ScriptPlan& script, std::string& error);
/** Unloads what scripts loaded into the component after those in `before`. */
void unloadScripts(RTT::TaskContext& component, const std::vector<LoadedScript>& now,
                   const std::vector<LoadedScript>& before);

}  // namespace OCL::deploy

#endif
