// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The command line of orocreate-pkg.
#ifndef OROFORGE_GENERATOR_DRIVER_OPTIONS_HPP
#define OROFORGE_GENERATOR_DRIVER_OPTIONS_HPP

#include <optional>
#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::driver {

struct Options {
    std::vector<std::string> words;  ///< package name, then kinds
    std::string from;                ///< manifest of a new package
    std::string generate;            ///< manifest to generate base classes from
    std::string output;              ///< folder for generated files; with --describe, a file
    std::string depfile;
    std::string depfileTarget;  ///< target in the depfile; empty = the generated files
    std::string templateDir;
    std::vector<std::string> add;  ///< kind and name of a part for the package in the current directory
    std::string nameSpace;         ///< of new classes
    std::string className;         ///< instead of the package's name with a capital letter
    std::string license;
    std::vector<std::string> authors;  ///< "Ann Other <ann@example.org>"
    std::string dump;                  ///< "model" or "view": print that step instead of writing files
    std::string format = "text";       ///< of diagnostics, see report::formatNames()
    bool explain = false;              ///< print what the codes in `words` mean
    bool listOutputs = false;
    bool force = false;
    bool dryRun = false;             ///< print what would be written
    bool list = false;               ///< print the kinds and templates
    bool catkin = false;             ///< for a catkin workspace
    bool upgrade = false;            ///< `words` are packages of the original toolchain
    bool describe = false;           ///< `words` are headers and sources to describe as a manifest
    std::string package;             ///< name of the package of the described classes
    std::vector<std::string> flags;  ///< for the compiler
    std::string database;            ///< compile database with more flags, see flags/compile_database.hpp
    std::string databaseEntry;
    bool update = false;                    ///< make the user's classes follow the manifest
    std::vector<std::string> takeManifest;  ///< names: change the code
    std::vector<std::string> takeCode;      ///< names: leave the code as it is
    std::vector<std::string> includes;      ///< folders with headers for the package's sources
    bool check = false;  ///< with --generate and --update: report stale files instead of writing them
};

/// Returns nothing if the program must end with `status`: 0 after --help or --version, 1 after a reported error.
std::optional<Options> parseOptions(int argc, const char* const* argv, diag::Sink& sink, int& status);

}  // namespace oroforge::driver

#endif
