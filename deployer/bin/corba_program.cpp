// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "corba_program.hpp"

#include <ocl/CorbaDeploymentComponent.hpp>
#include <rtt/Logger.hpp>
#include <rtt/os/SignalCatcher.hpp>
#include <rtt/transports/corba/TaskContextServer.hpp>

namespace OCL::deploy {

using RTT::corba::TaskContextServer;

std::unique_ptr<DeploymentComponent> makeCorbaDeployer(const Options& options, std::vector<char*>& words) {
    const int count = static_cast<int>(words.size()) - 1;  // a null ends the list
    if (!options.dryRun && !TaskContextServer::InitOrb(count, words.data())) return nullptr;
    auto made = std::make_unique<CorbaDeploymentComponent>(options.name, options.siteFile, purposeOf(options));
    const bool isServed =
        options.endsAtOnce() || TaskContextServer::Create(made.get(), /*use_naming=*/true, options.requireNameService);
    if (!isServed) return nullptr;
    return made;
}

bool stayForOthers(DeploymentComponent&, SignalCatcher& ending, const Options&, bool deployed) {
    if (!deployed) return true;
    TaskContextServer::RunOrb(ending.descriptor());
    if (ending.caught()) RTT::log(RTT::Info) << "ending on signal " << ending.wait() << RTT::endlog();
    return true;
}

void endCorba() { TaskContextServer::DestroyOrb(); }

}  // namespace OCL::deploy
