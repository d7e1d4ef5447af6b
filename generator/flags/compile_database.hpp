// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reads compiler options from a compile_commands.json, as CMake, Meson and Bear write it.
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
    std::string source;              ///< source of the entry that was used
};

/// `database` is a file, or the folder of compile_commands.json. `wanted` selects an entry by the end of its source's
/// path or by the name of its CMake target. If it is empty, the first entry of the C++ source is used which
///   1. includes most of the headers by itself,
///   2. else has the file name of one of them (x.cpp for x.hpp),
///   3. else is in the nearest folder.
/// Returns nothing, after errors TK066, if there is no such entry or the file is malformed.
std::optional<DatabaseFlags> readCompileDatabase(const std::string& database, const std::string& wanted,
                                                 const std::vector<std::string>& headers, diag::Sink& sink);

/// Returns the database file itself, given a file or a folder.
std::string compileDatabaseFile(const std::string& database);

/// Returns the flags without macros and a standard that `stronger`, the words of a command line, sets itself.
std::vector<std::string> withoutOverridden(const std::vector<std::string>& flags,
                                           const std::vector<std::string>& stronger);

}  // namespace oroforge::flags

#endif
