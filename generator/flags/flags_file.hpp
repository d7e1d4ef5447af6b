// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reads options for the compiler of the generated files, as a build tool writes them down (--flags-from).
#ifndef OROFORGE_GENERATOR_FLAGS_FLAGS_FILE_HPP
#define OROFORGE_GENERATOR_FLAGS_FLAGS_FILE_HPP

#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::flags {

/// Splits a line as pkg-config prints it: blanks separate words, a backslash protects the next character.
std::vector<std::string> splitFlags(const std::string& line);

/// Keeps the words that change what a header means: -I, -isystem, -include, -D, -U and standards from C++17 on. Lower
/// standards are left out, because the build raises them; so are -I, -D and -U without a value, which come from empty
/// expressions. CMake writes "SHELL:…" for several words.
std::vector<std::string> meaningfulFlags(const std::vector<std::string>& words);

/// Does the same for a file with one word a line. Returns nothing after an error TK008 if it cannot be read.
std::vector<std::string> readFlagsFile(const std::string& file, diag::Sink& sink);

}  // namespace oroforge::flags

#endif
