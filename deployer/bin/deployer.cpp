// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// deployer-<target>: deploys the files of the command line and runs until the user leaves the console or a signal
// comes.
#include "console_stay.hpp"

int main(int argc, char** argv) {
    const OCL::deploy::ProgramText text = {
        "Creates, connects, configures and starts the components that the files describe,\n"
        "and runs them until its console is left or SIGTERM, SIGHUP or SIGINT comes. The\n"
        "console is on the terminal; without one, commands are read from standard input,\n"
        "at whose end it is left. With --daemon there is none.",
        /*needsFiles=*/false};
    return OCL::deploy::runProgram(argc, argv, {text, &OCL::deploy::stayAtConsole});
}
