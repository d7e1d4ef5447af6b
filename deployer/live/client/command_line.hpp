// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reads the command line by the table of commands.
#ifndef OROFORGE_LIVE_CLIENT_COMMAND_LINE_HPP
#define OROFORGE_LIVE_CLIENT_COMMAND_LINE_HPP

#include "session.hpp"

#include <string>
#include <vector>

namespace oroforge::live_client {

/** What was given. Without a command, `help` is what to print instead. */
struct CommandLine {
    Given given;
    std::string help;
};

/** Reads the words behind the name of the program. Throws a Failure if they are wrong. */
CommandLine readCommandLine(const std::vector<std::string>& words);

}  // namespace oroforge::live_client

#endif
