// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "lua_program.hpp"

#include "crash_report.hpp"
#include "live_window.hpp"
#include "lua_session.hpp"
#include "program_report.hpp"
#include "real_time_check.hpp"
#include "replay.hpp"

#include <rtt/Logger.hpp>
#include <rtt/os/SignalCatcher.hpp>
#include <rtt/os/startstop.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <iostream>
#include <optional>
#include <string>

#include <unistd.h>

namespace OCL::deploy {
namespace {

constexpr int kFailure = 1;  // as of other interpreters

/** Ends what the program has begun beside the components. */
struct AtEnd {
    ~AtEnd() {
        if (end) end();
    }
    void (*end)();
};

/** The command line as Lua and the runtime see it. */
struct Words {
    Words(int argc, char** argv, bool splits) {
        char** const last = argv + argc;
        char** const split =
            splits ? std::find_if(argv + 1, last, [](char* word) { return !std::strcmp(word, "--"); }) : last;
        isSplit = split != last;
        lua.assign(argv, split);
        // Without "--", the runtime sees all, of which ROS takes its own.
        runtime.assign(argv, isSplit ? argv + 1 : last);
        if (isSplit) runtime.insert(runtime.end(), split + 1, last);
        runtime.push_back(nullptr);
    }
    std::vector<std::string> lua;
    std::vector<char*> runtime;
    bool isSplit;
};

std::unique_ptr<DeploymentComponent> makeDeployer(const LuaProgram& program, Words& words) {
    std::unique_ptr<DeploymentComponent> made;
    if (words.isSplit) made = program.makeServer(words.runtime);
    if (words.isSplit && !made) RTT::log(RTT::Warning) << "other processes cannot use the deployer" << RTT::endlog();
    if (!made) made = std::make_unique<DeploymentComponent>();
    return made;
}

/** The options that the deployer has, too. False, with the reason, if they are wrong. */
bool sharedOptions(LuaCommandLine& line, const LuaProgram& program, Options& options) {
    std::vector<std::string> given{program.name};
    given.insert(given.end(), line.shared.begin(), line.shared.end());
    std::vector<char*> words;
    for (std::string& word : given) words.push_back(word.data());
    words.push_back(nullptr);
    const bool good = parseOptions(static_cast<int>(given.size()), words.data(), options, line.error);
    options.name = program.name;
    if (line.script) options.files = {line.words[line.script]};
    return good;
}

int interpret(const LuaCommandLine& line, const LuaProgram& program, const Options& options, Words& words,
              ProgramReport& report) {
    // Catches signals from now on, so that one during start-up ends the program in order, too.
    std::optional<RTT::os::SignalCatcher> ending;
    ending.emplace(std::initializer_list<int>{SIGINT, SIGTERM, SIGHUP});
    std::unique_ptr<Replay> replay;
    if (!options.replayFile.empty() && !(replay = Replay::open(options, report))) return kFailure;
    LiveWindow listening(options);
    if (listening.failed()) return kFailure;
    const AtEnd atEnd{program.end};
    // Outlives the components that the deployer has loaded, which may call it.
    const LuaOwner owner = program.makeLua();
    const std::unique_ptr<DeploymentComponent> deployer = makeDeployer(program, words);
    owner.component->connectPeers(deployer.get());
    int status = kFailure;
    {
        const LiveWindow::Opened live(listening, *deployer);
        if (live) status = runLuaSession(line, program.name, *owner.state, ending->descriptor());
        if (status == 0 && replay && !replay->run(*deployer, *ending)) status = kFailure;
    }
    ending.reset();  // so that the next signal ends a shutdown that hangs
    deployer->shutdownDeployment();
    return status;
}

int runWithRuntime(const LuaCommandLine& line, const LuaProgram& program, const Options& options, Words& words,
                   ProgramReport& report) {
    if (!options.replayFile.empty()) standStill();
    if (__os_init(static_cast<int>(words.runtime.size()) - 1, words.runtime.data()) != 0) {
        std::cerr << program.name << ": the runtime does not start\n";
        return kFailure;
    }
    reportCrashes();
    const RTT::Logger::In in(program.name);
    int status = kFailure;
    try {
        status = interpret(line, program, options, words, report);
    } catch (const std::exception& thrown) {
        RTT::log(RTT::Critical) << "uncaught exception: " << thrown.what() << RTT::endlog();
    }
    __os_exit();
    return status;
}

}  // namespace

int runLuaProgram(int argc, char** argv, const LuaProgram& program) {
    // A reader of the output, such as roslaunch, sees each line at once.
    if (!isatty(STDOUT_FILENO)) std::setvbuf(stdout, nullptr, _IOLBF, 0);
    Words words(argc, argv, program.makeServer != nullptr);
    LuaCommandLine line = parseLuaCommandLine(words.lua);
    Options options;
    if (!line.error.empty() || !sharedOptions(line, program, options)) {
        std::cerr << program.name << ": " << line.error << '\n' << luaUsage(program.name);
        return kFailure;
    }
    ProgramReport report(program.name, oroforge::report::Format::Text);
    if (options.replayCheck) {
        const std::string error = startRealTimeCheck(argv, CheckedFor::Replay);
        if (!error.empty()) {
            report.error("", error);
            return kFailure;
        }
    }
    const int status = runWithRuntime(line, program, options, words, report);
    return options.replayCheck && !reportRealTimeCheck(report) ? kFailure : status;
}

}  // namespace OCL::deploy
