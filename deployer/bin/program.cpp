// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "program.hpp"

#include "../deployment/lenient.hpp"
#include "../deployment/signals.hpp"
#include "crash_report.hpp"
#include "explain.hpp"
#include "real_time_check.hpp"
#include "real_time_memory.hpp"
#include "script_end.hpp"

#include <diag/print.hpp>
#include <ocl/DeploymentComponent.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/FailureReport.hpp>
#include <rtt/os/startstop.h>
#include <rtt/types/SizeLimit.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <optional>
#include <vector>

#include <sched.h>
#include <unistd.h>

namespace OCL::deploy {
namespace {

constexpr int kFailure = 255;
constexpr int kTooFewProcessors = 254;

bool endsWith(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/** Checks the script first: what is certain to fail is reported before a statement is executed. */
bool runScript(DeploymentComponent& deployer, const std::string& file, const Options& options) {
    if ((endsWith(file, ".lua") || deployer.checkScript(file)) && deployer.runScript(file)) return true;
    if (!options.consoleLog) std::cerr << file << ": error: could not run the script, the log file says why\n";
    return false;
}

bool deployFile(DeploymentComponent& deployer, const std::string& file, const Options& options) {
    for (const char* suffix : {".xml", ".cpf"})
        if (endsWith(file, suffix))
            return options.dryRun ? deployer.planOnly(file) : deployer.kickStart2(file, !options.check);
    for (const char* suffix : {".ops", ".osd"})
        if (options.endsAtOnce() && endsWith(file, suffix)) return deployer.checkScript(file);
    for (const char* suffix : {".ops", ".osd", ".lua"})
        if (endsWith(file, suffix)) return runScript(deployer, file, options);
    std::cerr
        << file
        << ": error: unknown kind of file, expected .xml or .cpf for deployment, .ops, .osd or .lua for scripts\n";
    return false;
}

/** For the handler of signals: what is being deployed when one comes. */
char endNotice[512];

void tellOfEnd() {
    const ssize_t written = write(STDERR_FILENO, endNotice, std::strlen(endNotice));
    (void)written;
}

bool deployFiles(DeploymentComponent& deployer, SignalCatcher& ending, const Options& options) {
    bool all = !deployer.siteFileFailed();
    if (!all && !options.dryRun) return false;
    for (const std::string& file : options.files) {
        if (ending.caught()) {
            std::cerr << file << ": error: not deployed: a signal came that ends the program\n";
            return false;
        }
        std::snprintf(
            endNotice, sizeof endNotice,
            "%.360s: a signal came that ends the program, after the present step; a script is stopped after two "
            "seconds, and a second signal ends all at once\n",
            file.c_str());
        ending.atFirst(&tellOfEnd);
        const bool good = deployFile(deployer, file, options);
        ending.atFirst(nullptr);
        all = good && all;
        if (!all && !options.dryRun) return false;  // a dry run tells the errors of all files
    }
    return all;
}

/** Writes the graph where one is wanted. */
bool writeGraph(const DeploymentComponent& deployer, const std::string& file) {
    if (file.empty()) return true;
    std::ofstream out(file);
    if (out << deployer.graph() && out.flush()) return true;
    std::cerr << file << ": error: the graph cannot be written: " << std::strerror(errno) << "\n";
    return false;
}

/** So that somebody sees how much was looked at. */
void tellSummary(const DeploymentComponent& deployer) {
    const std::string planned = deployer.planSummary();
    if (!planned.empty()) std::cout << planned << ": ok; scripts not executed" << std::endl;
}

int deploy(const Options& options, Stay stay) {
    // Caught from now on, so that a signal during start-up ends the program in order as well.
    std::optional<SignalCatcher> ending;
    ending.emplace(std::initializer_list<int>{SIGINT, SIGTERM, SIGHUP});
    std::optional<ScriptEnd> scriptEnd(std::in_place, *ending);
    RTT::internal::FailureReport::setStrict(options.strict);
    setLenient(options.lenient);
    if (options.maxElements != 0) RTT::types::setSizeLimit(options.maxElements);
    using Purpose = DeploymentComponent::Purpose;
    DeploymentComponent deployer(options.name, options.siteFile,
                                 options.dryRun  ? Purpose::PlanOnly
                                 : options.check ? Purpose::Check
                                                 : Purpose::Deploy);
    const bool deployed = deployFiles(deployer, *ending, options) && writeGraph(deployer, options.graphFile);
    if (options.dryRun && deployed) tellSummary(deployer);
    scriptEnd.reset();  // those of the shutdown have a limit of their own
    bool succeeded = deployed;
    if (!options.endsAtOnce()) {
        succeeded = stay(deployer, *ending, options, deployed) && deployed;
        ending.reset();  // the next signal ends a shutdown that hangs
        deployer.shutdownDeployment();
    }
    return succeeded ? 0 : kFailure;
}

/** The processors that this process may run on. */
int processors() {
    cpu_set_t set;
    CPU_ZERO(&set);
    return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

int runWithRuntime(const std::vector<char*>& words, const Options& options, Stay stay) {
    if (__os_init(static_cast<int>(words.size()) - 1, const_cast<char**>(words.data())) != 0) {
        std::cerr << words.front() << ": error: the runtime does not start\n";
        return kFailure;
    }
    tellCrashes();
    int status = kFailure;
    try {
        status = deploy(options, stay);
    } catch (const std::exception& thrown) {
        RTT::log(RTT::Critical) << "uncaught exception: " << thrown.what() << RTT::endlog();
    }
    __os_exit();
    return status;
}

/** What is only checked, or ends after its files, is of no use without any: a word is missing, perhaps an empty variable. */
bool hasFiles(const Options& options, const ProgramText& text, std::string& error) {
    const bool needsFiles = options.action == Options::Run && (text.needsFiles || options.endsAtOnce());
    std::error_code unreadable;  // which is told when it is read
    if (!needsFiles || !options.files.empty() || !options.siteFile.empty() ||
        std::filesystem::exists(options.siteFileOrDefault(), unreadable) || unreadable)
        return true;
    error = "no file is given";
    return false;
}

}  // namespace

int runProgram(int argc, char** argv, const ProgramText& text, Stay stay) {
    const std::string program = std::filesystem::path(argv[0]).filename().string();
    Options options;
    std::string error;
    if (!parseOptions(argc, argv, options, error) || !hasFiles(options, text, error)) {
        std::cerr << program << ": error: " << error << "\n" << program << " --help shows all options\n";
        return kFailure;
    }
    if (!options.warning.empty()) std::cerr << program << ": warning: " << options.warning << "\n";
    if (options.action == Options::Explain) return explain(options.codes, program) ? 0 : kFailure;
    if (options.action != Options::Run) {
        std::cout << (options.action == Options::ShowHelp ? usage(program, text) : version(program));
        return oroforge::diag::arrived(std::cout, std::cerr, program) ? 0 : kFailure;
    }
    if (processors() < options.minimumProcessors) {
        std::cerr << program << ": error: " << options.minimumProcessors
                  << " processors are needed, and this process has " << processors() << "\n";
        return kTooFewProcessors;
    }
    if (options.realTimeCheck) error = startRealTimeCheck(argv);
    // Threads do not survive a fork: this comes before the runtime starts.
    const pid_t child = error.empty() && options.daemon ? fork() : 0;
    if (child > 0) _exit(0);
    if (child < 0) error = std::string("cannot go to the background: ") + std::strerror(errno);

    if (error.empty() && options.realTimeMemory != 0) error = setRealTimeMemoryAside(options.realTimeMemory);
    if (!error.empty()) {
        std::cerr << program << ": error: " << error << "\n";
        return kFailure;
    }
    if (options.lockMemory)  // after the fork, which locks do not survive
        if (const std::string problem = lockMemory(); !problem.empty())
            std::cerr << program << ": warning: " << problem << "\n";
    if (options.logLevel >= 0) RTT::Logger::Instance()->setLogLevel(static_cast<RTT::LoggerLevel>(options.logLevel));
    if (!options.consoleLog) RTT::Logger::Instance()->mayLogStdOut(false);
    int status = runWithRuntime(wordsForRuntime(argc, argv), options, stay);
    if (options.realTimeMemory != 0) reportRealTimeMemory();
    if (options.realTimeCheck && !reportRealTimeCheck(program)) status = kFailure;
    return status;
}

}  // namespace OCL::deploy
