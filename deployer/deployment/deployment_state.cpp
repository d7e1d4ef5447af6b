// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "deployment_state.hpp"

#include "report.hpp"
#include "script_forecast.hpp"
#include "scripts.hpp"

#include <rtt/Logger.hpp>
#include <rtt/internal/located_log.hpp>
#include <rtt/os/SignalCatcher.hpp>
#include <rtt/os/fosi.h>

#include <iostream>
#include <sstream>
#include <utility>

namespace OCL {

DeploymentComponent::Impl::Impl() : target(OROCOS_TARGET_NAME) { session.waitPeriodPolicy = ORO_WAIT_ABS; }

bool DeploymentComponent::Impl::load(const deploy::Plan& plan, oroforge::diag::Sink& sink) {
    const RTT::Logger::In in(session.deployer->getName());
    const State before = state();
    const int group = session.nextGroup++;
    valid = deploy::load(session, plan, group, sink);
    deploy::report(sink);
    if (!valid) undo(group, before);
    return valid;
}

bool DeploymentComponent::Impl::plan(deploy::Plan plan, oroforge::diag::Sink& sink) {
    const RTT::Logger::In in(session.deployer->getName());
    const bool good = deploy::prepare(session, plan, /*planOnly=*/true, sink);
    deploy::report(sink);
    session.planned.push_back(std::move(plan));
    return good;
}

bool DeploymentComponent::Impl::configure(int group) {
    const RTT::Logger::In in(session.deployer->getName());
    oroforge::diag::Sink sink;
    valid = deploy::configure(session, group, sink);
    // The components have the values now. Until then a file serves all groups.
    if (group + 1 == session.nextGroup) session.propertyFiles->clear();
    deploy::report(sink);
    return valid;
}

bool DeploymentComponent::Impl::start(int group) {
    const RTT::Logger::In in(session.deployer->getName());
    oroforge::diag::Sink sink;
    const bool started = deploy::start(session, group, sink);
    deploy::report(sink);
    return started;
}

bool DeploymentComponent::Impl::checkScript(const std::string& file) {
    using deploy::Foresight;
    // The script may use the operations of this service, because it has them when it runs.
    (void)deploy::loadService(*session.deployer, "scripting");
    // Planned components do not exist.
    for (const deploy::Plan& plan : session.planned)
        for (const deploy::ComponentPlan& component : plan.components)
            if (!session.component(component.name.value)) expected.components.insert(component.name.value);
    if (purpose != Purpose::Deploy) {
        expected.doubts = true;
        deploy::ScriptForecast forecast(session, Foresight::Check);
        return RTT::scripting::checkScript(file, *session.deployer, std::cerr, forecast, expected);
    }
    const deploy::KeptSearchPath paths;  // the script adds to it when it runs
    deploy::ScriptForecast forecast(session, Foresight::Run);
    RTT::scripting::Expectations ofThisOne;
    forecast.expectRunning(ofThisOne);
    std::ostringstream messages;
    if (RTT::scripting::checkScript(file, *session.deployer, messages, forecast, ofThisOne)) return true;
    std::string text = messages.str();
    if (!text.empty()) text.pop_back();  // the last line end
    RTT::internal::logLocated(RTT::Error, text);
    return false;
}

bool DeploymentComponent::Impl::goesOn(const std::string& file) const {
    const int signal = RTT::os::pendingSignal();
    if (signal != 0)
        RTT::log(RTT::Error) << "signal " << signal << " came while '" << file << "' was being deployed"
                             << RTT::endlog();
    return signal == 0;
}

DeploymentComponent::Impl::State DeploymentComponent::Impl::state() const {
    return {session.records.all, session.records.policies};
}

void DeploymentComponent::Impl::undo(int group, const State& before) {
    (void)deploy::takeDown(session, group);
    session.propertyFiles->clear();
    session.records.policies = before.policies;
    if (const auto former = session.formerDefaults.find(group); former != session.formerDefaults.end()) {
        RTT::ConnPolicy::Default() = former->second;
        session.formerDefaults.erase(former);
    }
    // Components that scripts created or that could not be removed must stay known.
    for (const deploy::ComponentRecord& old : before.records)
        if (deploy::ComponentRecord* const left = session.records.find(old.instance)) {
            deploy::unloadScripts(*left->instance, left->loaded, old.loaded);
            *left = old;
        }
}

bool DeploymentComponent::Impl::forGroupsDown(bool (*step)(deploy::Session&, int)) {
    const RTT::Logger::In in(session.deployer->getName());
    bool all = true;
    for (int group = session.nextGroup; group >= 0; --group) all &= step(session, group);
    return all;
}

}  // namespace OCL
