// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Options of the compiler that will compile the generated files, as a build tool writes them down (--flags-from).
#ifndef OROFORGE_GENERATOR_FLAGS_FLAGS_FILE_HPP
#define OROFORGE_GENERATOR_FLAGS_FLAGS_FILE_HPP

#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::flags {

/// Words of a line as pkg-config prints it: blanks separate, a backslash protects the next character.
std::vector<std::string> splitFlags(const std::string& line);

/// Those of the words that change what a header means: include folders, macros, standards from C++17 on. Lower standards
/// are left out as the build raises them; so are -I, -D and -U without a value, which empty expressions leave behind.
/// A word "SHELL:…" is CMake's for several words.
std::vector<std::string> meaningfulFlags(const std::vector<std::string>& words);

/// The same of a file with one word a line. Nothing and an error TK008 if it cannot be read.
std::vector<std::string> readFlagsFile(const std::string& file, diag::Sink& sink);

}  // namespace oroforge::flags

#endif
