// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// deployer-<target>: deploys the files of the command line and runs them until a signal comes.
#include "deployer_options.hpp"
#include "real_time_memory.hpp"

#include "../deployment/signals.hpp"

#include <ocl/DeploymentComponent.hpp>
#include <rtt/Logger.hpp>
#include <rtt/os/startstop.h>
#include <rtt/scripting/check.hpp>

#include <exception>
#include <initializer_list>
#include <iostream>
#include <optional>
#include <vector>

#include <unistd.h>

namespace {

constexpr int kFailure = 255;

bool endsWith(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool deployFile(OCL::DeploymentComponent& deployer, const std::string& file, bool check) {
    for (const char* suffix : {".xml", ".cpf"})
        if (endsWith(file, suffix)) return deployer.kickStart2(file, !check);
    for (const char* suffix : {".ops", ".osd"})
        if (check && endsWith(file, suffix)) return RTT::scripting::checkScript(file, deployer, std::cerr);
    for (const char* suffix : {".ops", ".osd", ".lua"})
        if (endsWith(file, suffix)) return deployer.runScript(file);
    std::cerr
        << file
        << ": error: unknown kind of file, expected .xml or .cpf for deployment, .ops, .osd or .lua for scripts\n";
    return false;
}

int deploy(const OCL::deploy::Options& options) {
    // Caught from now on, so that a signal during start-up ends the program in order as well.
    std::optional<OCL::deploy::SignalCatcher> ending;
    ending.emplace(std::initializer_list<int>{SIGINT, SIGTERM, SIGHUP});
    OCL::DeploymentComponent deployer(options.name, options.siteFile);
    for (const std::string& file : options.files)
        if (!deployFile(deployer, file, options.check)) return kFailure;
    if (options.check) return 0;
    RTT::log(RTT::Info) << "ending on signal " << ending->wait() << RTT::endlog();
    ending.reset();  // the next signal ends a shutdown that hangs
    deployer.shutdownDeployment();
    return 0;
}

int run(int argc, char** argv) {
    using OCL::deploy::Options;
    Options options;
    std::string error;
    if (!OCL::deploy::parseOptions(argc, argv, options, error)) {
        std::cerr << argv[0] << ": error: " << error << "\n\n" << OCL::deploy::usage(argv[0]);
        return kFailure;
    }
    if (options.action != Options::Run) {
        std::cout << (options.action == Options::ShowHelp ? OCL::deploy::usage(argv[0])
                                                          : OCL::deploy::version(argv[0]));
        return 0;
    }
    // Threads do not survive a fork: this comes before the runtime starts.
    if (options.daemon && fork() != 0) _exit(0);

    if (options.realTimeMemory != 0) error = OCL::deploy::setRealTimeMemoryAside(options.realTimeMemory);
    if (!error.empty()) {
        std::cerr << argv[0] << ": error: " << error << "\n";
        return kFailure;
    }
    if (options.logLevel >= 0) RTT::Logger::Instance()->setLogLevel(static_cast<RTT::LoggerLevel>(options.logLevel));
    if (!options.consoleLog) RTT::Logger::Instance()->mayLogStdOut(false);
    std::vector<char*> words = OCL::deploy::wordsForRuntime(argc, argv);
    if (__os_init(static_cast<int>(words.size()) - 1, words.data()) != 0) {
        std::cerr << argv[0] << ": error: the runtime does not start\n";
        return kFailure;
    }
    int status = kFailure;
    try {
        status = deploy(options);
    } catch (const std::exception& thrown) {
        RTT::log(RTT::Critical) << "uncaught exception: " << thrown.what() << RTT::endlog();
    }
    __os_exit();
    if (options.realTimeMemory != 0) OCL::deploy::reportRealTimeMemory();
    return status;
}

}  // namespace

int main(int argc, char** argv) { return run(argc, argv); }
