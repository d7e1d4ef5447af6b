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
    std::string output;              ///< where generated files go
    std::string depfile;
    std::string depfileTarget;  ///< what the depfile is about; empty = the files that are generated
    std::string templateDir;
    std::vector<std::string> add;  ///< kind and name of a part for the package in the current directory
    std::string nameSpace;         ///< of the classes that are made
    std::string className;         ///< instead of the package's name with its first letter upper-cased
    std::string license;
    std::vector<std::string> authors;  ///< "Ann Other <ann@example.org>"
    std::string dump;                  ///< "model" or "view": print that step instead of writing files
    std::string format = "text";       ///< of diagnostics, see report::formatNames()
    bool explain = false;              ///< tell what the codes mean that `words` then are
    bool listOutputs = false;
    bool force = false;
    bool dryRun = false;             ///< tell what would be written
    bool list = false;               ///< tell which kinds and templates there are
    bool catkin = false;             ///< for a catkin workspace
    bool upgrade = false;            ///< `words` are packages of the original toolchain
    bool describe = false;           ///< `words` are headers and sources to be described as a manifest
    std::string package;             ///< name of the package that they belong to
    std::vector<std::string> flags;  ///< of the compiler, for what is read with one
    std::string database;            ///< more of them, see flags/compile_database.hpp
    std::string databaseEntry;
    bool update = false;                    ///< bring the user's classes up to date with the manifest
    std::vector<std::string> takeManifest;  ///< names: change what stands in the code
    std::vector<std::string> takeCode;      ///< names: leave what stands in the code
    std::vector<std::string> includes;      ///< folders where sources of the package find headers
    bool check = false;  ///< with --generate and --update: tell which files are stale instead of writing them
};

/// Nothing if the program is to end with `status`: after --help or --version (0), or a wrong command line (1, reported).
std::optional<Options> parseOptions(int argc, const char* const* argv, diag::Sink& sink, int& status);

}  // namespace oroforge::driver

#endif
