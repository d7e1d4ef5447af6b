// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The private part of a DeploymentComponent.
#ifndef OROFORGE_DEPLOYMENT_STATE_HPP
#define OROFORGE_DEPLOYMENT_STATE_HPP

#include <ocl/DeploymentComponent.hpp>

#include "session.hpp"

#include <rtt/scripting/check.hpp>

#include <string>

namespace OCL {

struct DeploymentComponent::Impl {
    Impl();

    /** Loads a plan as the next group, reports errors, and undoes everything if there are any. */
    bool load(const deploy::Plan& plan, oroforge::diag::Sink& sink);
    /** Only prepares a plan, after those that were planned before, and reports errors. */
    bool plan(deploy::Plan plan, oroforge::diag::Sink& sink);
    bool configure(int group);
    bool start(int group);
    /** Reports and returns false if a signal has come that ends the program. */
    bool goesOn(const std::string& file) const;
    bool checkScript(const std::string& file);
    /** What a file changes, apart from creating components. */
    struct State {
        std::list<deploy::ComponentRecord> records;
        std::map<std::string, deploy::PolicyPlan> policies;
    };
    State state() const;
    /** Removes what a group created, and restores the state from before its file. */
    void undo(int group, const State& before);
    bool forGroupsDown(bool (*step)(deploy::Session&, int));

    deploy::Session session;
    DeploymentComponent::Purpose purpose = DeploymentComponent::Purpose::Deploy;
    RTT::scripting::Expectations expected;  // from the scripts that were checked
    // The values of the component's properties and attributes.
    std::string componentPath;
    bool autoUnload = true;
    bool valid = false;
    bool siteFileFailed = false;
    std::string target;
};

}  // namespace OCL

#endif
