// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The commands of the console that are no script.
#ifndef OROFORGE_CONSOLE_COMMANDS_HPP
#define OROFORGE_CONSOLE_COMMANDS_HPP

#include "session.hpp"

#include <vector>

namespace OCL::console {

/** What completes the word behind a command. */
enum class Argument { None, Component, Path, Name, Scripted, File, Service, Port };

struct Command {
    const char* word;
    const char* arguments;  ///< for help: "[PATH]"
    const char* help;
    Argument argument;
    void (*act)(Session& session, const Input& input);
};

/** Words such as `ls`; and those that begin with a dot. In the order of the help. */
const std::vector<Command>& commands();
const std::vector<Command>& dotCommands();

/** The command that the line is; null if it is none. Such a word is a command only if a blank or nothing follows, and not an
    assignment. */
const Command* commandIn(const Input& input);

/** Executes it, unless there are words that it does not take. */
void execute(const Command& command, Session& session, const Input& input);

/** The text of `help`. */
void writeHelp(Screen& screen);

/** An error for a path that leads nowhere, beginning at `at` in the line. */
void complainOf(Session& session, const Input& input, std::size_t at, const Lookup& lookup);

}  // namespace OCL::console

#endif
