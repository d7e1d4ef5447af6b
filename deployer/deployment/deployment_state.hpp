// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The private part of a DeploymentComponent.
#ifndef OROFORGE_DEPLOYMENT_STATE_HPP
#define OROFORGE_DEPLOYMENT_STATE_HPP

#include <ocl/DeploymentComponent.hpp>

#include "session.hpp"

#include <string>

namespace OCL {

struct DeploymentComponent::Impl {
    Impl();

    /** Loads a plan as the next group, reports, and undoes everything if anything was wrong. */
    bool load(const deploy::Plan& plan, oroforge::diag::Sink& sink);
    /** Only prepares a plan, as the next one after those planned before, and reports. */
    bool plan(deploy::Plan plan, oroforge::diag::Sink& sink);
    bool configure(int group);
    bool start(int group);
    /** Removes what a group created and forgets what its file said. */
    void undo(int group, const deploy::Records& before);
    bool forGroupsDown(bool (*step)(deploy::Session&, int));

    deploy::Session session;
    // Behind the properties and attributes of the component.
    std::string componentPath;
    bool autoUnload = true;
    bool valid = false;
    std::string target;
};

}  // namespace OCL

#endif
