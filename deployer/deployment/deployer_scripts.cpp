// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "deployer_scripts.hpp"

#include "failure.hpp"
#include "libraries.hpp"
#include "script_forecast.hpp"
#include "scripts.hpp"

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/located_log.hpp>

#include <iostream>
#include <sstream>

namespace OCL::deploy {

bool DeployerScripts::run(const std::string& file) {
    std::string error;
    const std::string what = "could not run script '" + file + "'";
    const auto run = [&] { return runScript(*session_.deployer, ScriptPlan::Run, file, error); };
    if (reported(what, run)) return true;
    if (!error.empty()) RTT::log(RTT::Error) << what << ": " << error << RTT::endlog();
    return false;
}

bool DeployerScripts::check(const std::string& file, bool runs) {
    // The script may use the operations of this service, because it has them when it runs.
    (void)loadService(*session_.deployer, "scripting");
    // Planned components do not exist.
    for (const Plan& plan : session_.planned)
        for (const ComponentPlan& component : plan.components)
            if (!session_.component(component.name.value)) expected_.components.insert(component.name.value);
    if (!runs) {
        expected_.doubts = true;
        ScriptForecast forecast(session_, Foresight::Check);
        return RTT::scripting::checkScript(file, *session_.deployer, std::cerr, forecast, expected_);
    }
    const KeptSearchPath paths;  // the script adds to it when it runs
    ScriptForecast forecast(session_, Foresight::Run);
    RTT::scripting::Expectations ofThisOne;
    forecast.expectRunning(ofThisOne);
    std::ostringstream messages;
    if (RTT::scripting::checkScript(file, *session_.deployer, messages, forecast, ofThisOne)) return true;
    std::string text = messages.str();
    if (!text.empty()) text.pop_back();  // the last line end
    RTT::internal::logLocated(RTT::Error, text);
    return false;
}

}  // namespace OCL::deploy
