// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The command line of the deployer programs.
#ifndef OROFORGE_DEPLOYER_OPTIONS_HPP
#define OROFORGE_DEPLOYER_OPTIONS_HPP

#include <report/report.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace OCL::deploy {

struct Options {
    enum Action { Run, ShowHelp, ShowVersion, Explain } action = Run;
    std::string name = "Deployer";
    std::string warning;  // of what was understood, and perhaps not meant
    std::string siteFile;
    std::vector<std::string> files;  // in the order of processing
    std::vector<std::string> codes;  // to be explained; empty: list them all
    int logLevel = -1;               // a RTT::LoggerLevel; −1: not given
    bool consoleLog = true;
    bool check = false;
    bool dryRun = false;
    bool strict = false;
    bool lenient = false;
    std::string graphFile;  // for the graph of the components; empty: none wanted
    oroforge::report::Format format = oroforge::report::Format::Text;
    bool daemon = false;
    bool realTimeCheck = false;
    bool lockMemory = false;
    int minimumProcessors = 0;
    std::size_t realTimeMemory = 0;  // bytes; 0: not given
    std::size_t maxElements = 0;     // 0: not given

    bool endsAtOnce() const { return check || dryRun; }
    /** The file that is deployed before all others if there is one. */
    std::string siteFileOrDefault() const { return siteFile.empty() ? name + "-site.cpf" : siteFile; }
};

/** Reads the command line. False, with the reason, if it cannot be understood. */
bool parseOptions(int argc, char** argv, Options& options, std::string& error);

/** What is said of a program that differs from others with the same command line. */
struct ProgramText {
    const char* purpose;
    bool needsFiles;  // has nothing to do without any
};

/** What --help shows. */
std::string usage(const std::string& program, const ProgramText& text);
/** What --version shows. */
std::string version(const std::string& program);
/** "2.10.0" */
std::string programVersion();

/** The program's name and, if there is a "--", what stands after it, else all; a null ends the list. */
std::vector<char*> wordsForRuntime(int argc, char** argv);

}  // namespace OCL::deploy

#endif
