// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_SCRIPTS_HPP
#define OROFORGE_DEPLOYMENT_SCRIPTS_HPP

#include "records.hpp"

#include <string>

namespace OCL::deploy {

/** The name of the service that runs such a file. */
std::string serviceFor(ScriptPlan::Kind kind, const std::string& file);

/** Has that service of the component run or load a script file; loads the service. False with the reason, which is empty if the
    log has it. */
bool runScript(RTT::TaskContext& component, ScriptPlan::Kind kind, const std::string& file, std::string& error);

/** The same for a script that a file names for the component of the record. If it ran before, what it loaded then is unloaded
    first: the component has these programs and state machines once. */
bool runScript(Record& record, const ScriptPlan& script, std::string& error);
/** Unloads what scripts loaded into the component after those in `before` had been run. */
void unloadScripts(RTT::TaskContext& component, const std::vector<LoadedScript>& now,
                   const std::vector<LoadedScript>& before);

}  // namespace OCL::deploy

#endif
