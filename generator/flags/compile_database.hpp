// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Options of the compiler out of a compile_commands.json, as CMake, Meson and Bear write it.
#ifndef OROFORGE_GENERATOR_FLAGS_COMPILE_DATABASE_HPP
#define OROFORGE_GENERATOR_FLAGS_COMPILE_DATABASE_HPP

#include <optional>
#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::flags {

struct DatabaseFlags {
    std::vector<std::string> flags;  ///< -I -isystem -D -U -include -std; folders and files are absolute
    std::string file;                ///< the database that was read
    std::string source;              ///< whose entry was taken
};

/// `database`: a file, or the folder of compile_commands.json. The entry is that of `wanted`, which is the end of a
/// source's path or the name of a CMake target. With `wanted` empty it is that of the C++ source which
///   1. includes most of the headers by itself,
///   2. else has the file name of one of them (x.cpp for x.hpp),
///   3. else lies in the nearest folder;
/// the first such entry. Nothing, and errors TK066, if there is none or the file makes no sense.
std::optional<DatabaseFlags> readCompileDatabase(const std::string& database, const std::string& wanted,
                                                 const std::vector<std::string>& headers, diag::Sink& sink);

/// The file itself, of a file or a folder.
std::string compileDatabaseFile(const std::string& database);

/// Without the macros and the standard that `stronger`, the words of a command line, sets itself.
std::vector<std::string> withoutOverridden(const std::vector<std::string>& flags,
                                           const std::vector<std::string>& stronger);

}  // namespace oroforge::flags

#endif
