// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The common part of all programs that deploy files; each has a short main file of its own.
#ifndef OROFORGE_DEPLOYER_PROGRAM_HPP
#define OROFORGE_DEPLOYER_PROGRAM_HPP

#include "deployer_options.hpp"

namespace RTT::os {
class SignalCatcher;
}
namespace OCL {
class DeploymentComponent;
}

namespace OCL::deploy {

using RTT::os::SignalCatcher;

/** Runs after the files are deployed, until the program should end. `deployed` is false if a file failed; those after
    it were not tried. SIGINT, SIGTERM and SIGHUP go to `ending`. Returns false if something failed. */
using Stay = bool (*)(DeploymentComponent& deployer, SignalCatcher& ending, const Options& options, bool deployed);

/** Parses the command line, starts the runtime, deploys the files, calls `stay`, and takes all down. Returns the exit
    status. */
int runProgram(int argc, char** argv, const ProgramText& text, Stay stay);

}  // namespace OCL::deploy

#endif
