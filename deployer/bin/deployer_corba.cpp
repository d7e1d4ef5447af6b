// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// deployer-corba-<target>: a deployer with a console that other processes use.
#include "corba_program.hpp"
#include "console_stay.hpp"

int main(int argc, char** argv) {
    using namespace OCL::deploy;
    const ProgramText text = {
        "Creates, connects, configures and starts the components that the files describe,\n"
        "and runs them until its console is left or SIGTERM, SIGHUP or SIGINT comes. Other\n"
        "processes can use it meanwhile.",
        /*needsFiles=*/false};
    return runProgram(argc, argv, {text, &stayAtConsole, &makeCorbaDeployer, &endCorba});
}
