// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The command line of the deployer programs.
#ifndef OROFORGE_DEPLOYER_OPTIONS_HPP
#define OROFORGE_DEPLOYER_OPTIONS_HPP

#include <live/rights.hpp>
#include <report/report.hpp>
#include <rtt/Logger.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace OCL::deploy {

struct Options {
    enum Action { Run, ShowHelp, ShowVersion, Explain } action = Run;
    std::string name = "Deployer";
    std::string warning;  // about a command line that is valid but may not be meant
    std::string siteFile;
    std::vector<std::string> files;  // in the order of deployment
    std::vector<std::string> codes;  // to explain; empty: list all
    std::string categoryFile;        // the property file of log4cpp; empty: none
    int logLevel = -1;               // a RTT::LoggerLevel; −1: not given
    std::optional<RTT::LogTime> logTime;
    bool consoleLog = true;
    bool check = false;
    bool dryRun = false;
    bool strict = false;
    bool lenient = false;
    std::string graphFile;  // gets the graph of the components; empty: no graph
    oroforge::report::Format format = oroforge::report::Format::Text;
    bool daemon = false;
    bool realTimeCheck = false;
    bool lockMemory = false;
    bool requireNameService = false;
    int minimumProcessors = 0;
    std::size_t realTimeMemory = 0;     // bytes; 0: not given
    std::size_t maxElements = 0;        // 0: not given
    std::string replayFile;             // a recording; empty: components run in real time
    std::string recordFile;             // what its components send; empty: it is not recorded
    std::vector<std::string> replaced;  // by the recording; empty: those that only sent what it has
    bool tolerate = false;              // recorded types may differ
    bool replayCheck = false;
    double replaySpeed = 0;  // 0: as fast as possible
    bool live = true;        // other programs of this user may look at the deployment
    std::string webAddress;  // and through this port; empty: there is none
    std::string webTokenFile;
    std::vector<std::string> webOrigins;  // sites whose pages may connect
    live::Rights webMay;                  // what they may do there

    bool endsAtOnce() const { return check || dryRun; }
    /** The file that is deployed before all others, if it exists. */
    std::string siteFileOrDefault() const { return siteFile.empty() ? name + "-site.cpf" : siteFile; }
};

/** Parses the command line. False, with the reason, if it is invalid. */
bool parseOptions(int argc, char** argv, Options& options, std::string& error);

/** What --help says of a program with this command line. */
struct ProgramText {
    const char* purpose;
    bool needsFiles;  // without files, it has nothing to do
};

/** The text of --help. */
std::string usage(const std::string& program, const ProgramText& text);
/** The text of --version. */
std::string version(const std::string& program);
/** "deployer" for "/usr/bin/deployer-gnulinux". */
std::string partName(const std::string& program);
/** "2.10.0" */
std::string programVersion();

/** The program's name and the words after "--", or all words if there is no "--"; a null ends the list. */
std::vector<char*> wordsForRuntime(int argc, char** argv);

}  // namespace OCL::deploy

#endif
