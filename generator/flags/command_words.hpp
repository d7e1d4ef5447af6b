// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Takes the command of a compile database apart.
#ifndef OROFORGE_GENERATOR_FLAGS_COMMAND_WORDS_HPP
#define OROFORGE_GENERATOR_FLAGS_COMMAND_WORDS_HPP

#include <string>
#include <vector>

namespace oroforge::flags {

/// Splits a line as a POSIX shell does with quotes and backslashes; other shell syntax is not known.
std::vector<std::string> splitCommand(const std::string& line);

/// Returns the options of a compiler command that change what a header means; relative paths are below `directory`.
/// Standards below C++17 and C standards are left out. "@FILE" is replaced by the words in that file.
std::vector<std::string> flagsOfCommand(const std::vector<std::string>& words, const std::string& directory);

/// Returns the value of -o, or nothing.
std::string outputOfCommand(const std::vector<std::string>& words);

}  // namespace oroforge::flags

#endif
