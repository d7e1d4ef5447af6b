// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "lua_program.hpp"

#include "../console/interrupts.hpp"
#include "../lua/interpreter.hpp"
#include "crash_report.hpp"
#include "lua_session.hpp"

#include <rtt/Logger.hpp>
#include <rtt/os/SignalCatcher.hpp>
#include <rtt/os/startstop.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <iostream>
#include <optional>

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

int interpret(const LuaCommandLine& line, const LuaProgram& program, std::vector<char*>& words) {
    // Catches signals from now on, so that one during start-up ends the program in order, too.
    std::optional<RTT::os::SignalCatcher> ending;
    ending.emplace(std::initializer_list<int>{SIGINT, SIGTERM, SIGHUP});
    const AtEnd atEnd{program.end};
    // Outlives the components that the deployer has loaded, which may call it.
    const LuaOwner owner = program.makeLua();
    const std::unique_ptr<DeploymentComponent> deployer = program.makeDeployer(words);
    owner.component->connectPeers(deployer.get());
    const int status = runLuaSession(line, program.name, *owner.state, ending->descriptor());
    ending.reset();  // so that the next signal ends a shutdown that hangs
    deployer->shutdownDeployment();
    return status;
}

int runWithRuntime(const LuaCommandLine& line, const LuaProgram& program, std::vector<char*> words) {
    if (__os_init(static_cast<int>(words.size()) - 1, words.data()) != 0) {
        std::cerr << program.name << ": the runtime does not start\n";
        return kFailure;
    }
    reportCrashes();
    int status = kFailure;
    try {
        status = interpret(line, program, words);
    } catch (const std::exception& thrown) {
        RTT::log(RTT::Critical) << "uncaught exception: " << thrown.what() << RTT::endlog();
    }
    __os_exit();
    return status;
}

}  // namespace

std::unique_ptr<DeploymentComponent> makePlainDeployer(std::vector<char*>&) {
    return std::make_unique<DeploymentComponent>();
}

int runLuaProgram(int argc, char** argv, const LuaProgram& program) {
    char** const last = argv + argc;
    char** const split = program.wordsForRuntime
                             ? std::find_if(argv + 1, last, [](char* word) { return !std::strcmp(word, "--"); })
                             : last;
    const LuaCommandLine line = parseLuaCommandLine({argv, split});
    if (!line.error.empty()) {
        std::cerr << program.name << ": " << line.error << '\n' << luaUsage(program.name);
        return kFailure;
    }
    std::vector<char*> words(argv, argv + 1);
    if (split != last) words.insert(words.end(), split + 1, last);
    words.push_back(nullptr);
    return runWithRuntime(line, program, std::move(words));
}

}  // namespace OCL::deploy
