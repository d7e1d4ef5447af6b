// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The reach of code that a script calls: what may have changed afterwards.
#include "script_forecast.hpp"

#include <rtt/TaskContext.hpp>

namespace OCL::deploy {

RTT::TaskContext* ScriptForecast::known(const std::string& name, const Expectations& expected) const {
    return expected.components.count(name) ? nullptr : session_.component(name);
}

void ScriptForecast::foreignCode(Expectations& expected) const {
    // Code may replace an operation of a component by another one of the same name.
    if (isRun())
        anyOperation(expected);
    else
        expected.anyGlobals();
}

void ScriptForecast::touch(RTT::TaskContext& component, Expectations& expected) const {
    foreignCode(expected);
    std::set<RTT::TaskContext*> reached;
    std::vector<RTT::TaskContext*> next{&component};
    while (!next.empty()) {
        RTT::TaskContext* const one = next.back();
        next.pop_back();
        if (one == session_.deployer) return anyOperation(expected);
        expected.more.insert(one);
        for (const std::string& name : one->getPeerList())
            if (RTT::TaskContext* const peer = one->getPeer(name))
                if (reached.insert(peer).second) next.push_back(peer);
    }
}

void ScriptForecast::touchAll(Expectations& expected) const {
    foreignCode(expected);
    for (const std::string& name : session_.deployer->getPeerList())
        if (RTT::TaskContext* const peer = session_.deployer->getPeer(name)) touch(*peer, expected);
}

/** Components may be destroyed, and others created with their names. */
void ScriptForecast::anyOperation(Expectations& expected) const {
    expected.anything();
    for (const std::string& name : session_.deployer->getPeerList()) expected.components.insert(name);
}

void ScriptForecast::expectRunning(Expectations& expected) const {
    if (session_.deployer->isRunning()) anyOperation(expected);
    for (const std::string& name : session_.deployer->getPeerList())
        if (RTT::TaskContext* const peer = session_.deployer->getPeer(name))
            if (peer->isRunning()) touch(*peer, expected);
}

}  // namespace OCL::deploy
