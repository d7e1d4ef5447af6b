// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "real_time_check.hpp"

#include "../rt_check/interface.h"

#include <diag/print.hpp>
#include <diag/sink.hpp>
#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/HookInProgress.hpp>
#include <rtt/os/real_time_thread.hpp>
#include <rtt/os/real_time_wanted.hpp>

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include <dlfcn.h>
#include <unistd.h>

namespace OCL::deploy {
namespace {

using RTT::internal::HookInProgress;

/** Tells the program that it was executed anew: what LD_PRELOAD was before, after a '='. */
const char* const kExecutedAnew = "OROFORGE_RT_CHECK_PRELOADED_BEFORE";

decltype(&oroforge_rt_check_begin) beginWatch;
decltype(&oroforge_rt_check_end) endWatch;
decltype(&oroforge_rt_check_findings) findings;

bool isRealTime(const HookInProgress& hook) {
    RTT::base::ActivityInterface* const activity = hook.task ? hook.task->engine()->getActivity() : nullptr;
    RTT::os::ThreadInterface* const thread = activity ? activity->thread() : nullptr;
    return (thread && RTT::os::realTimeWanted(*thread)) || RTT::os::inRealTimeThread();
}

bool isUpdateHook(const HookInProgress& hook) { return std::strcmp(hook.hook, "updateHook()") == 0; }

void onBegin(const HookInProgress& hook) {
    if (!isUpdateHook(hook)) return;
    const bool realTime = isRealTime(hook);
    // The logger's line of this thread: a real-time thread has one before it executes anything.
    if (realTime) const RTT::Logger::In prepared("updateHook");
    beginWatch(hook.component, realTime);
}

void onEnd(const HookInProgress& hook) {
    if (isUpdateHook(hook)) endWatch();
}

const RTT::internal::HookWatch kWatch = {&onBegin, &onEnd};

/** Below the folder of the runtime's library. */
std::string libraryFile() {
    Dl_info info{};
    if (dladdr(dlsym(RTLD_DEFAULT, "__os_init"), &info) == 0) return {};
    const std::string file = info.dli_fname;
    return file.substr(0, file.rfind('/') + 1) + "oroforge/liborocos-rtcheck-" OROCOS_TARGET_NAME ".so";
}

std::string thisProgram() {
    char file[PATH_MAX];
    const ssize_t size = readlink("/proc/self/exe", file, sizeof file);
    return size > 0 ? std::string(file, static_cast<std::size_t>(size)) : std::string();
}

std::string executeAnew(char** words) {
    const std::string library = libraryFile();
    if (access(library.c_str(), R_OK) != 0)
        return "--rt-check needs the library '" + library + "': " + std::strerror(errno) +
               "; builds with a sanitizer do not have it";
    const char* const before = std::getenv("LD_PRELOAD");
    const std::string others = before ? before : "";
    setenv(kExecutedAnew, ("=" + others).c_str(), 1);
    setenv("LD_PRELOAD", (others.empty() ? library : library + ":" + others).c_str(), 1);
    const std::string program = thisProgram();
    execv(program.c_str(), words);
    return "--rt-check cannot execute '" + program + "' anew: " + std::strerror(errno);
}

/** Programs that a component starts are not checked. */
void restoreEnvironment(const std::string& preloaded) {
    unsetenv(kExecutedAnew);
    if (preloaded.empty())
        unsetenv("LD_PRELOAD");
    else
        setenv("LD_PRELOAD", preloaded.c_str(), 1);
}

template <class Function>
void find(Function& function, const char* name) {
    function = reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

const char* verbOf(oroforge_rt_fault fault) {
    switch (fault) {
        case OROFORGE_RT_ALLOCATION: return "allocates memory";
        case OROFORGE_RT_RELEASE: return "frees memory";
        case OROFORGE_RT_LOCK: return "takes a lock";
        case OROFORGE_RT_WAIT: return "waits";
        case OROFORGE_RT_SYSTEM_CALL: return "makes a system call that may block";
        case OROFORGE_RT_STREAM: return "uses a stream of the C library";
    }
    return "";
}

std::string times(unsigned long count, const char* one, const char* many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

void add(void* to, const oroforge_rt_finding* finding) {
    oroforge::diag::Diagnostic& diagnostic = static_cast<oroforge::diag::Sink*>(to)->error(
        {}, "RTC00" + std::to_string(finding->fault),
        std::string("component '") + finding->component + "' " + verbOf(finding->fault) +
            " in updateHook(): " + finding->function + "(), " + times(finding->count, "time", "times"));
    for (unsigned i = 0; i != finding->depth; ++i) diagnostic.hint(std::string("called by ") + finding->frames[i]);
}

}  // namespace

std::string startRealTimeCheck(char** words) {
    const char* const anew = std::getenv(kExecutedAnew);
    if (!anew) return executeAnew(words);
    restoreEnvironment(anew + 1);
    find(beginWatch, "oroforge_rt_check_begin");
    find(endWatch, "oroforge_rt_check_end");
    find(findings, "oroforge_rt_check_findings");
    if (!beginWatch || !endWatch || !findings)
        return "--rt-check: the system did not load '" + libraryFile() +
               "' before the program, as it refuses for programs with capabilities or another user's rights; run "
               "without these, as root, or with a limit for real-time priorities instead";
    HookInProgress::setWatch(&kWatch);
    return {};
}

bool reportRealTimeCheck(const std::string& program) {
    HookInProgress::setWatch(nullptr);
    oroforge::diag::Sink sink;
    const oroforge_rt_totals totals = findings(&add, &sink);
    oroforge::diag::print(std::cerr, sink);
    if (totals.lost != 0)
        std::cerr << program << ": warning: --rt-check had no room for "
                  << times(totals.lost, "more call", "more calls") << "\n";
    if (totals.hooks == 0)
        std::cerr << program << ": warning: --rt-check saw no updateHook() of a component with a real-time scheduler\n";
    else
        std::cerr << program << ": --rt-check: " << times(sink.errorCount(), "finding", "findings") << " in "
                  << times(totals.hooks, "execution", "executions") << " of updateHook()\n";
    return sink.errorCount() == 0;
}

}  // namespace OCL::deploy
