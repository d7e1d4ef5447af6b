// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// cdeployer-<target>: a deployer that other processes use. It has no console; ctaskbrowser is one.
#include "corba_program.hpp"

int main(int argc, char** argv) {
    using namespace OCL::deploy;
    const ProgramText text = {
        "Creates, connects, configures and starts the components that the files describe,\n"
        "and serves other processes until SIGTERM, SIGHUP or SIGINT comes, or one of them\n"
        "calls its operation 'shutdown'. ctaskbrowser shows it in another terminal.",
        /*needsFiles=*/false};
    return runProgram(argc, argv, {text, &stayForOthers, &makeCorbaDeployer, &endCorba});
}
