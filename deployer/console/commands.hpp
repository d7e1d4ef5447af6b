// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The commands of the console, other than script statements.
#ifndef OROFORGE_CONSOLE_COMMANDS_HPP
#define OROFORGE_CONSOLE_COMMANDS_HPP

#include "console_state.hpp"

#include <vector>

namespace OCL::console {

/** What completes the word after a command. */
enum class Argument { None, Component, Path, Name, Scripted, File, Service, Port };

struct Command {
    const char* word;
    const char* arguments;  ///< for the help text: "[PATH]"
    const char* help;
    Argument argument;
    void (*act)(ConsoleState& state, const Input& input);
};

/** All commands, plain and with a dot, in the order of the help text. */
const std::vector<Command>& commands();
const std::vector<Command>& dotCommands();

/** The command with which the line begins; null if there is none. The word is a command only if it is followed by a
    blank or nothing, and not by an assignment. */
const Command* commandIn(const Input& input);

/** Executes the command, unless there are words that it does not take. */
void execute(const Command& command, ConsoleState& state, const Input& input);

/** The text of `help`. */
void writeHelp(Screen& screen);

/** The port at the path that the word is; null, with an error, if there is none. */
RTT::base::PortInterface* findPort(ConsoleState& state, const Input& input, const Word& word);
/** Prints an error and returns false if the command has too few words. */
bool hasWords(ConsoleState& state, const Input& input, std::size_t count, const char* expected);

// `.watch` and `.hz`.
void watchPort(ConsoleState& state, const Input& input);
void showRate(ConsoleState& state, const Input& input);

/** Prints an error for a path that leads nowhere and begins at `at` in the line. */
void complainOf(ConsoleState& state, const Input& input, std::size_t at, const ResolvedName& lookup);

}  // namespace OCL::console

#endif
