// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "deployment_state.hpp"

#include "report.hpp"

#include <rtt/Logger.hpp>
#include <rtt/os/fosi.h>

#include <utility>

namespace OCL {

DeploymentComponent::Impl::Impl() : target(OROCOS_TARGET_NAME) { session.waitPeriodPolicy = ORO_WAIT_ABS; }

bool DeploymentComponent::Impl::load(const deploy::Plan& plan, oroforge::diag::Sink& sink) {
    const RTT::Logger::In in(session.deployer->getName());
    const deploy::Records before = session.records;
    const int group = session.nextGroup++;
    valid = deploy::load(session, plan, group, sink);
    deploy::report(sink);
    if (!valid) undo(group, before);
    return valid;
}

bool DeploymentComponent::Impl::plan(deploy::Plan plan, oroforge::diag::Sink& sink) {
    const RTT::Logger::In in(session.deployer->getName());
    const bool good = deploy::prepare(session, plan, sink);
    deploy::report(sink);
    session.planned.push_back(std::move(plan));
    return good;
}

bool DeploymentComponent::Impl::configure(int group) {
    const RTT::Logger::In in(session.deployer->getName());
    oroforge::diag::Sink sink;
    valid = deploy::configure(session, group, sink);
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

void DeploymentComponent::Impl::undo(int group, const deploy::Records& before) {
    (void)deploy::takeDown(session, group);
    session.records.policies = before.policies;
    // What scripts created meanwhile, or could not be removed, has to stay known.
    for (deploy::Record& record : session.records.all)
        for (const deploy::Record& old : before.all)
            if (old.instance == record.instance) record = old;
}

bool DeploymentComponent::Impl::forGroupsDown(bool (*step)(deploy::Session&, int)) {
    const RTT::Logger::In in(session.deployer->getName());
    bool all = true;
    for (int group = session.nextGroup; group >= 0; --group) all &= step(session, group);
    return all;
}

}  // namespace OCL
