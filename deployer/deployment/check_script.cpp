// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "libraries.hpp"
#include "script_forecast.hpp"
#include "scripts.hpp"

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/located_log.hpp>

#include <iostream>
#include <sstream>

namespace OCL::deploy {

bool checkScript(Session& session, const std::string& file, bool runs) {
    if (isLua(file)) {
        const std::string fault = luaFault(*session.deployer, file);
        if (!fault.empty()) std::cerr << fault << '\n';
        return fault.empty();
    }
    // The script may use the operations of this service, because it has them when it runs.
    (void)loadService(*session.deployer, "scripting");
    // Planned components do not exist.
    for (const Plan& plan : session.planned)
        for (const ComponentPlan& component : plan.components)
            if (!session.component(component.name.value)) session.expected.components.insert(component.name.value);
    if (!runs) {
        session.expected.doubts = true;
        ScriptForecast forecast(session, Foresight::Check);
        return RTT::scripting::checkScript(file, *session.deployer, std::cerr, forecast, session.expected);
    }
    const KeptSearchPath paths;  // the script adds to it when it runs
    ScriptForecast forecast(session, Foresight::Run);
    RTT::scripting::Expectations ofThisOne;
    forecast.expectRunning(ofThisOne);
    std::ostringstream messages;
    if (RTT::scripting::checkScript(file, *session.deployer, messages, forecast, ofThisOne)) return true;
    std::string text = messages.str();
    if (!text.empty()) text.pop_back();  // the last line end
    RTT::internal::logLocated(RTT::Error, text);
    return false;
}

}  // namespace OCL::deploy
