// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Command line of typegen: the original's options, and those compiler options that change what a header means.
#ifndef OROFORGE_TYPEKIT_GEN_DRIVER_OPTIONS_HPP
#define OROFORGE_TYPEKIT_GEN_DRIVER_OPTIONS_HPP

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <report/report.hpp>

namespace oroforge::typekit {

enum class Dump { None, Model, View };

struct Options {
    std::string name;                  ///< of the typekit
    std::vector<std::string> inputs;   ///< headers and folders
    std::string output;                ///< folder, default "./NAME"
    std::vector<std::string> imports;  ///< packages whose include folders are needed
    std::vector<std::string> flags;    ///< for the compiler
    std::string target = "gnulinux";
    std::string flagsFile;                         ///< file with more flags, see flags/flags_file.hpp
    std::string database;                          ///< compile database with more flags, see flags/compile_database.hpp
    std::string databaseEntry;                     ///< source or target whose entry is used; empty = the best
    std::map<std::string, std::string> includeAs;  ///< input → how generated code includes it
    std::map<std::string, std::size_t> pieces;     ///< input → number of source files for its types
    std::vector<std::string> transports;           ///< to generate for
    bool diff = false;                             ///< compare two versions of headers, which are the only two inputs
    bool check = false;                            ///< compare with existing files, and write nothing
    std::string refresh;                           ///< what to do when the check fails
    std::vector<std::string> adapters;             ///< files that describe how classes are shown
    std::string depfile;
    std::string depfileTarget;  ///< target in the depfile; empty = the generated files
    std::string templateDir;
    Dump dump = Dump::None;
    report::Format format = report::Format::Text;
    bool strict = false;  ///< classes that are not values are errors
    bool explain = false;
    std::vector<std::string> codes;  ///< to explain; empty = list all codes
    bool listOutputs = false;
    bool verbose = false;
    bool help = false;
    bool version = false;
};

/// Returns nothing, after errors TK003, if the words are not a valid command line.
std::optional<Options> parseOptions(const std::vector<std::string>& words, diag::Sink& sink);

std::string usage();

}  // namespace oroforge::typekit

#endif
