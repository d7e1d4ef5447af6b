// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The command of a compile database, taken apart.
#ifndef OROFORGE_GENERATOR_FLAGS_COMMAND_WORDS_HPP
#define OROFORGE_GENERATOR_FLAGS_COMMAND_WORDS_HPP

#include <string>
#include <vector>

namespace oroforge::flags {

/// Words as a POSIX shell makes them of quotes and backslashes; nothing else of the shell's is known.
std::vector<std::string> splitCommand(const std::string& line);

/// Those options of a compiler's command that change what a header means; relative paths are below `directory`.
/// Standards below C++17 and those of C are left out. "@FILE" stands for the words in that file.
std::vector<std::string> flagsOfCommand(const std::vector<std::string>& words, const std::string& directory);

/// The value of -o, or nothing.
std::string outputOfCommand(const std::vector<std::string>& words);

}  // namespace oroforge::flags

#endif
