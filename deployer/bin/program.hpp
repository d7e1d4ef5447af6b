// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What all programs that deploy files have in common; each has a short main file of its own.
#ifndef OROFORGE_DEPLOYER_PROGRAM_HPP
#define OROFORGE_DEPLOYER_PROGRAM_HPP

#include "deployer_options.hpp"

namespace OCL {
class DeploymentComponent;
}

namespace OCL::deploy {

class SignalCatcher;

/** Runs once the files are processed, until the program is to end. `deployed` is false if one could not be, and those after
    it were not tried. SIGINT, SIGTERM and SIGHUP go to `ending`. False if something failed. */
using Stay = bool (*)(DeploymentComponent& deployer, SignalCatcher& ending, const Options& options, bool deployed);

/** Reads the command line, starts the runtime, processes the files, stays, takes everything down. Returns the exit status. */
int runProgram(int argc, char** argv, const ProgramText& text, Stay stay);

}  // namespace OCL::deploy

#endif
