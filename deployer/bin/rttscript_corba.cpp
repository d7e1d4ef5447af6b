// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// rttscript-corba-<target>: deploys the files of the command line and ends; scripts can use other processes.
#include "corba_program.hpp"

namespace {

bool leave(OCL::DeploymentComponent&, OCL::deploy::SignalCatcher&, const OCL::deploy::Options&, bool) { return true; }

}  // namespace

int main(int argc, char** argv) {
    using namespace OCL::deploy;
    const ProgramText text = {
        "Deploys the files and runs the scripts, one after the other, then stops and\n"
        "removes all components and ends. Scripts can use components of other processes,\n"
        "and these its components meanwhile.",
        /*needsFiles=*/true};
    return runProgram(argc, argv, {text, &leave, &makeCorbaDeployer, &endCorba});
}
