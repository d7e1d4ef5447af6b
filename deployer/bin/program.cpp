// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "program.hpp"

#include "../console/wanted.hpp"
#include "../deployment/lenient.hpp"
#include "categories.hpp"
#include "crash_report.hpp"
#include "explain.hpp"
#include "live_window.hpp"
#include "program_report.hpp"
#include "real_time_check.hpp"
#include "real_time_memory.hpp"
#include "replay.hpp"
#include "script_end.hpp"

#include <diag/print.hpp>
#include <ocl/DeploymentComponent.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/calls/failure_report.hpp>
#include <rtt/os/SignalCatcher.hpp>
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

/** Checks the script first, so that certain failures are reported before a statement is executed. */
bool runScript(DeploymentComponent& deployer, const std::string& file, const Options& options) {
    if ((endsWith(file, ".lua") || deployer.checkScript(file)) && deployer.runScript(file)) return true;
    if (!options.consoleLog) std::cerr << file << ": error: could not run the script, the log file says why\n";
    return false;
}

bool deployFile(DeploymentComponent& deployer, const std::string& file, const Options& options, ProgramReport& report) {
    for (const char* suffix : {".xml", ".cpf"})
        if (endsWith(file, suffix))
            return options.dryRun ? deployer.planOnly(file) : deployer.kickStart2(file, !options.check);
    for (const char* suffix : {".ops", ".osd", ".lua"})
        if (options.endsAtOnce() && endsWith(file, suffix)) return deployer.checkScript(file);
    for (const char* suffix : {".ops", ".osd", ".lua"})
        if (endsWith(file, suffix)) return runScript(deployer, file, options);
    report.error(file, "unknown kind of file, expected .xml or .cpf for deployment, .ops, .osd or .lua for scripts");
    return false;
}

/** The message that the signal handler writes if a signal comes during the deployment of a file. */
char endNotice[512];

void announceEnd() {
    const ssize_t written = write(STDERR_FILENO, endNotice, std::strlen(endNotice));
    (void)written;
}

/** A program that roslaunch has started is not in the folder that its user has in mind. */
void tellFolder(const std::string& file, const Options& options) {
    if (console::isWanted()) return;
    std::error_code error;
    const std::filesystem::path here = std::filesystem::current_path(error);
    if (error || options.format != oroforge::report::Format::Text || std::filesystem::path(file).is_absolute() ||
        std::filesystem::exists(file, error))
        return;
    std::cerr << file << ": note: looked for in the working folder, " << here.string() << '\n';
}

bool deployFiles(DeploymentComponent& deployer, SignalCatcher& ending, const Options& options, ProgramReport& report) {
    bool all = !deployer.siteFileFailed();
    if (!all && !options.dryRun) return false;
    for (const std::string& file : options.files) {
        if (ending.caught()) {
            report.error(file, "not deployed: a signal came that ends the program");
            return false;
        }
        std::snprintf(
            endNotice, sizeof endNotice,
            "%.360s: a signal came that ends the program, after the present step; a script is stopped after two "
            "seconds, and a second signal ends all at once\n",
            file.c_str());
        ending.atFirst(&announceEnd);
        const std::size_t before = report.errorCount();
        const bool good = deployFile(deployer, file, options, report);
        ending.atFirst(nullptr);
        if (!good) tellFolder(file, options);
        if (!good && !report.isText() && report.errorCount() == before)
            report.error(file, "could not be deployed; the log says why");
        all = good && all;
        if (!all && !options.dryRun) return false;  // a dry run reports the errors of all files
    }
    return all;
}

/** Writes the graph, if one is wanted. */
bool writeGraph(const DeploymentComponent& deployer, const std::string& file, ProgramReport& report) {
    if (file.empty()) return true;
    std::ofstream out(file);
    if (out << deployer.graph() && out.flush()) return true;
    report.error(file, std::string("the graph cannot be written: ") + std::strerror(errno));
    return false;
}

/** Shows users how much was checked. */
void printSummary(const DeploymentComponent& deployer) {
    const std::string planned = deployer.planSummary();
    if (!planned.empty()) std::cout << planned << ": ok; scripts not executed" << std::endl;
}

/** Ends what the program has begun beside the deployer. */
struct AtEnd {
    ~AtEnd() {
        if (end) end();
    }
    void (*end)();
};

int deploy(const Options& options, const Program& program, std::vector<char*>& words, ProgramReport& report) {
    // Catches signals from now on, so that one during start-up ends the program in order, too.
    std::optional<SignalCatcher> ending;
    ending.emplace(std::initializer_list<int>{SIGINT, SIGTERM, SIGHUP});
    std::optional<ScriptEnd> scriptEnd(std::in_place, *ending);
    RTT::internal::FailureReport::setStrict(options.strict);
    setLenient(options.lenient);
    if (options.maxElements != 0) RTT::types::setSizeLimit(options.maxElements);
    const AtEnd atEnd{program.end};
    std::unique_ptr<Replay> replay;
    if (!options.replayFile.empty() && !(replay = Replay::open(options, report))) return kFailure;
    LiveWindow listening(options);  // before the site file starts components
    if (listening.failed()) return kFailure;
    const std::unique_ptr<DeploymentComponent> made = program.make(options, words);
    if (!made) return kFailure;
    DeploymentComponent& deployer = *made;
    const LiveWindow::Opened live(listening, deployer);
    if (!live) return kFailure;
    const bool deployed =
        deployFiles(deployer, *ending, options, report) && writeGraph(deployer, options.graphFile, report);
    if (options.dryRun && deployed) printSummary(deployer);
    if (options.endsAtOnce() && deployed) std::cout << deployer.chains() << std::flush;
    scriptEnd.reset();  // scripts of the shutdown have a limit of their own
    bool succeeded = deployed;
    if (!options.endsAtOnce()) {
        if (!replay)
            succeeded = program.stay(deployer, *ending, options, deployed) && deployed;
        else
            succeeded = deployed && replay->run(deployer, *ending);
        ending.reset();  // so that the next signal ends a shutdown that hangs
        deployer.shutdownDeployment();
    }
    return succeeded ? 0 : kFailure;
}

/** The number of processors on which this process may run. */
int processors() {
    cpu_set_t set;
    CPU_ZERO(&set);
    return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

int runWithRuntime(std::vector<char*> words, const Options& options, const Program& program, ProgramReport& report) {
    if (__os_init(static_cast<int>(words.size()) - 1, words.data()) != 0) {
        report.error(words.front(), "the runtime does not start");
        return kFailure;
    }
    reportCrashes();
    int status = kFailure;
    if (const std::string problem = prepareCategories(options.categoryFile, options.dryRun); !problem.empty()) {
        report.error(options.categoryFile, problem);
        __os_exit();
        return kFailure;
    }
    try {
        status = deploy(options, program, words, report);
    } catch (const std::exception& thrown) {
        RTT::log(RTT::Critical) << "uncaught exception: " << thrown.what() << RTT::endlog();
    }
    __os_exit();
    return status;
}

/** A program that only checks, or ends after its files, needs one: if there is none, perhaps a shell variable is
    empty. */
bool hasFiles(const Options& options, const ProgramText& text, std::string& error) {
    const bool needsFiles = options.action == Options::Run && (text.needsFiles || options.endsAtOnce());
    std::error_code unreadable;  // reported when it is read
    if (!needsFiles || !options.files.empty() || !options.siteFile.empty() ||
        std::filesystem::exists(options.siteFileOrDefault(), unreadable) || unreadable)
        return true;
    error = "no file is given";
    return false;
}

/** Prints what the options ask for instead of a deployment. */
int printInformation(const Options& options, const ProgramText& text, const std::string& program,
                     ProgramReport& report) {
    if (options.action == Options::Explain) return explain(options.codes, program, report) ? 0 : kFailure;
    std::cout << (options.action == Options::ShowHelp ? usage(program, text) : version(program));
    return oroforge::diag::arrived(std::cout, std::cerr, program) ? 0 : kFailure;
}

int run(int argc, char** argv, const Options& options, const Program& program, ProgramReport& report) {
    if (processors() < options.minimumProcessors) {
        report.error("", std::to_string(options.minimumProcessors) + " processors are needed, and this process has " +
                             std::to_string(processors()));
        return kTooFewProcessors;
    }
    // A reader of the output, such as roslaunch, sees each line at once.
    if (!isatty(STDOUT_FILENO)) std::setvbuf(stdout, nullptr, _IOLBF, 0);
    std::string error;
    if (options.realTimeCheck) error = startRealTimeCheck(argv, CheckedFor::RealTime);
    if (options.replayCheck) error = startRealTimeCheck(argv, CheckedFor::Replay);
    // Threads do not survive a fork: this comes before the runtime starts.
    const pid_t child = error.empty() && options.daemon ? fork() : 0;
    if (child > 0) _exit(0);
    if (child < 0) error = std::string("cannot go to the background: ") + std::strerror(errno);

    report.reserveOutput();
    if (error.empty() && options.realTimeMemory != 0) error = setRealTimeMemoryAside(options.realTimeMemory);
    if (!error.empty()) {
        report.error("", error);
        return kFailure;
    }
    if (options.lockMemory)  // after the fork, because locks are not inherited
        if (const std::string problem = lockMemory(); !problem.empty()) report.warning(problem);
    if (!options.replayFile.empty()) standStill();
    const RTT::Logger::In in(partName(argv[0]));
    if (options.logTime) RTT::Logger::setLogTime(*options.logTime);  // before the first line
    if (options.logLevel >= 0) RTT::Logger::Instance()->setLogLevel(static_cast<RTT::LoggerLevel>(options.logLevel));
    if (!options.consoleLog) RTT::Logger::Instance()->mayLogStdOut(false);
    int status = runWithRuntime(wordsForRuntime(argc, argv), options, program, report);
    if (options.realTimeMemory != 0) reportRealTimeMemory();
    if ((options.realTimeCheck || options.replayCheck) && !reportRealTimeCheck(report)) status = kFailure;
    return status;
}

}  // namespace

DeploymentComponent::Purpose purposeOf(const Options& options) {
    using Purpose = DeploymentComponent::Purpose;
    return options.dryRun ? Purpose::PlanOnly : options.check ? Purpose::Check : Purpose::Deploy;
}

std::unique_ptr<DeploymentComponent> makeDeployer(const Options& options, std::vector<char*>&) {
    return std::make_unique<DeploymentComponent>(options.name, options.siteFile, purposeOf(options));
}

int runProgram(int argc, char** argv, const Program& program) {
    const std::string name = std::filesystem::path(argv[0]).filename().string();
    Options options;
    std::string error;
    const bool understood = parseOptions(argc, argv, options, error) && hasFiles(options, program.text, error);
    ProgramReport report(name, understood ? options.format : oroforge::report::wantedFormat({argv + 1, argv + argc}));
    if (options.endsAtOnce() || !understood) report.onlyInDocument();
    if (!understood) {
        report.error("", error, name + " --help shows all options");
        return report.finish(kFailure);
    }
    if (!options.warning.empty()) report.warning(options.warning);
    if (options.action == Options::Run) return report.finish(run(argc, argv, options, program, report));
    const int status = printInformation(options, program.text, name, report);
    return status == 0 ? 0 : report.finish(status);
}

}  // namespace OCL::deploy
