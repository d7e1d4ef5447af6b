// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// deployer-<target>: deploys the files of the command line and runs until the user leaves the console or a signal
// comes.
#include "program.hpp"

#include "../console/kept_terminal.hpp"

#include <ocl/DeploymentComponent.hpp>
#include <ocl/TaskBrowser.hpp>
#include <rtt/Logger.hpp>
#include <rtt/os/SignalCatcher.hpp>

namespace {

/** On a terminal, stays even after a failure, so that the user can look into it. */
bool stay(OCL::DeploymentComponent& deployer, OCL::deploy::SignalCatcher& ending, const OCL::deploy::Options& options,
          bool deployed) {
    if (!deployed && (options.daemon || !OCL::TaskBrowser::onTerminal())) return true;
    bool succeeded = true;
    if (!options.daemon) {
        OCL::TaskBrowser browser(&deployer);
        browser.endOn(ending.descriptor());
        RTT::os::beforeSecondSignal(&OCL::console::restoreTerminal);
        browser.loop();
        succeeded = !browser.failed();
        if (!ending.caught()) return succeeded;
    }
    RTT::log(RTT::Info) << "ending on signal " << ending.wait() << RTT::endlog();
    return succeeded;
}

}  // namespace

int main(int argc, char** argv) {
    const OCL::deploy::ProgramText text = {
        "Creates, connects, configures and starts the components that the files describe,\n"
        "and runs them until its console is left or SIGTERM, SIGHUP or SIGINT comes. The\n"
        "console is on the terminal; without one, commands are read from standard input,\n"
        "at whose end it is left. With --daemon there is none.",
        /*needsFiles=*/false};
    return OCL::deploy::runProgram(argc, argv, text, &stay);
}
