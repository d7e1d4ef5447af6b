// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// deployer-<target>: deploys the files of the command line and runs them until a signal comes.
#include "program.hpp"

#include "../deployment/signals.hpp"

#include <rtt/Logger.hpp>

namespace {

void stay(OCL::DeploymentComponent&, OCL::deploy::SignalCatcher& ending, const OCL::deploy::Options&, bool deployed) {
    if (deployed) RTT::log(RTT::Info) << "ending on signal " << ending.wait() << RTT::endlog();
}

}  // namespace

int main(int argc, char** argv) {
    const OCL::deploy::ProgramText text = {
        "Creates, connects, configures and starts the components that the files describe, and runs them until\n"
        "SIGINT, SIGTERM or SIGHUP."};
    return OCL::deploy::runProgram(argc, argv, text, &stay);
}
