// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_DEPLOYER_SCRIPTS_HPP
#define OROFORGE_DEPLOYMENT_DEPLOYER_SCRIPTS_HPP

#include "session.hpp"

#include <rtt/scripting/check.hpp>

namespace OCL::deploy {

/** Runs and checks scripts in the deployer itself. */
class DeployerScripts {
public:
    explicit DeployerScripts(Session& session) : session_(session) {}

    /** Reports why it returns false. */
    bool run(const std::string& file);
    /** Checks a script that runs afterwards, or one that does not, see DeploymentComponent::checkScript(). */
    bool check(const std::string& file, bool runs);

private:
    Session& session_;
    RTT::scripting::Expectations expected_;  // from the scripts that were checked and do not run
};

}  // namespace OCL::deploy

#endif
