// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// rttscript-<target>: deploys the files of the command line and ends. A script that should run longer must wait itself.
#include "program.hpp"

namespace {

bool leave(OCL::DeploymentComponent&, OCL::deploy::SignalCatcher&, const OCL::deploy::Options&, bool) { return true; }

}  // namespace

int main(int argc, char** argv) {
    const OCL::deploy::ProgramText text = {
        "Deploys the files and runs the scripts, one after the other, then stops and\n"
        "removes all components and ends. A script that is to go on until a signal comes\n"
        "ends with waitForInterrupt().",
        /*needsFiles=*/true};
    return OCL::deploy::runProgram(argc, argv, {text, &leave});
}
