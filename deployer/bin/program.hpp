// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The common part of all programs that deploy files; each has a short main file of its own.
#ifndef OROFORGE_DEPLOYER_PROGRAM_HPP
#define OROFORGE_DEPLOYER_PROGRAM_HPP

#include "deployer_options.hpp"

#include <ocl/DeploymentComponent.hpp>

#include <memory>
#include <vector>

namespace RTT::os {
class SignalCatcher;
}
namespace OCL::deploy {

using RTT::os::SignalCatcher;

/** Runs after the files are deployed, until the program should end. `deployed` is false if a file failed; those after
    it were not tried. SIGINT, SIGTERM and SIGHUP go to `ending`. Returns false if something failed. */
using Stay = bool (*)(DeploymentComponent& deployer, SignalCatcher& ending, const Options& options, bool deployed);

DeploymentComponent::Purpose purposeOf(const Options& options);

/** Makes the deployer; null, with an error logged, if the program cannot go on. The words are those for the runtime. */
using MakeDeployer = std::unique_ptr<DeploymentComponent> (*)(const Options& options, std::vector<char*>& words);
std::unique_ptr<DeploymentComponent> makeDeployer(const Options& options, std::vector<char*>& words);

/** How a program differs from others with the same command line. */
struct Program {
    ProgramText text;
    Stay stay;
    MakeDeployer make = &makeDeployer;
    void (*end)() = nullptr;  // after the deployer has ended
};

/** Parses the command line, starts the runtime, deploys the files, calls `stay`, and takes all down. Returns the exit
    status. */
int runProgram(int argc, char** argv, const Program& program);

}  // namespace OCL::deploy

#endif
