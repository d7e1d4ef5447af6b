// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Command line of typegen: the original's options, and those of a compiler that change what a header means.
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
    std::string flagsFile;                         ///< more of them, see flags/flags_file.hpp
    std::string database;                          ///< and more, see flags/compile_database.hpp
    std::string databaseEntry;                     ///< source or target whose entry is taken; empty = the best
    std::map<std::string, std::string> includeAs;  ///< input → how generated code includes it
    std::map<std::string, std::size_t> pieces;     ///< input → how many source files its types are dealt out to
    std::vector<std::string> transports;           ///< to generate for
    bool diff = false;                             ///< compare two versions of headers, the only two inputs
    bool check = false;                            ///< compare with what is there, and write nothing
    std::string refresh;                           ///< what to do when that fails
    std::vector<std::string> adapters;             ///< files that say how classes are seen
    std::string depfile;
    std::string depfileTarget;  ///< what the depfile is about; empty = the files that are generated
    std::string templateDir;
    Dump dump = Dump::None;
    report::Format format = report::Format::Text;
    bool strict = false;  ///< classes that are no values are errors
    bool explain = false;
    std::vector<std::string> codes;  ///< to explain; empty = list them all
    bool listOutputs = false;
    bool verbose = false;
    bool help = false;
    bool version = false;
};

/// Nothing, and errors TK003 in the sink, if the words make no sense.
std::optional<Options> parseOptions(const std::vector<std::string>& words, diag::Sink& sink);

std::string usage();

}  // namespace oroforge::typekit

#endif
