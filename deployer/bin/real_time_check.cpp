// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "real_time_check.hpp"

#include "../rt_check/interface.h"
#include "program_report.hpp"
#include "real_time_findings.hpp"
#include "source_lines.hpp"

#include <diag/print.hpp>
#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/engine/hook_in_progress.hpp>
#include <rtt/internal/engine/script_place.hpp>
#include <rtt/os/real_time_thread.hpp>
#include <rtt/os/real_time_wanted.hpp>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <utility>
#include <vector>

#include <dlfcn.h>
#include <unistd.h>

namespace OCL::deploy {
namespace {

using RTT::internal::HookInProgress;

/** The variable by which the program knows that it was executed anew: '=' and the previous value of LD_PRELOAD. */
const char* const kExecutedAnew = "OROFORGE_RT_CHECK_PRELOADED_BEFORE";

decltype(&oroforge_rt_check_begin) beginWatch;
decltype(&oroforge_rt_check_end) endWatch;
decltype(&oroforge_rt_check_findings) findings;
decltype(&oroforge_rt_check_scripts) describeScripts;

bool isRealTime(const HookInProgress& hook) {
    RTT::base::ActivityInterface* const activity = hook.task ? hook.task->engine()->getActivity() : nullptr;
    RTT::os::ThreadInterface* const thread = activity ? activity->thread() : nullptr;
    return (thread && RTT::os::realTimeWanted(*thread)) || RTT::os::inRealTimeThread();
}

/** The kinds of user code in a step of a component, in the order of oroforge_rt_place, and their names in the
    report. */
const struct {
    const char* hook;
    const char* where;
    const char* many;
} kPlaces[OROFORGE_RT_PLACES] = {{"updateHook()", "updateHook()", "updateHook()"},
                                 {"errorHook()", "errorHook()", "errorHook()"},
                                 {"the callback of a port", "the callback of a port", "callbacks of ports"},
                                 {"a message", "an operation", "operations"},
                                 {"a function", "a script", "scripts"},
                                 {"configureHook()", "configureHook()", "configureHook()"},
                                 {"startHook()", "startHook()", "startHook()"},
                                 {"its constructor", "its constructor", "constructors"}};

/** Those in which a component must be real-time safe. */
constexpr int kRealTimePlaces = OROFORGE_RT_CONFIGURE;

CheckedFor checkedFor = CheckedFor::RealTime;

const char* option() { return checkedFor == CheckedFor::RealTime ? "--rt-check" : "--replay-check"; }

/** The place of the hook; OROFORGE_RT_PLACES if it has none. */
int placeOf(const HookInProgress& hook) {
    int place = 0;
    while (place != OROFORGE_RT_PLACES && std::strcmp(hook.hook, kPlaces[place].hook) != 0) ++place;
    const bool isOther = checkedFor == CheckedFor::RealTime && place >= kRealTimePlaces;
    return isOther ? OROFORGE_RT_PLACES : place;
}

/** True if the component runs: before start(), its code need not be real-time safe. */
bool isRunning(const HookInProgress& hook) {
    using Core = RTT::base::TaskCore;
    return hook.task && hook.task->Core::getTaskState() >= Core::Running;
}

void onBegin(const HookInProgress& hook) {
    const int place = placeOf(hook);
    if (place == OROFORGE_RT_PLACES) return;
    const bool realTime = checkedFor == CheckedFor::Replay || (isRunning(hook) && isRealTime(hook));
    // Prepares the logger's buffer of this thread; a real-time thread has one before it executes anything.
    if (realTime) const RTT::Logger::In prepared(kPlaces[place].where);
    beginWatch(hook.component, static_cast<oroforge_rt_place>(place), realTime);
}

void onEnd(const HookInProgress& hook) {
    if (placeOf(hook) != OROFORGE_RT_PLACES) endWatch();
}

const RTT::internal::HookWatch kWatch = {&onBegin, &onEnd};

/** The preloaded library, below the folder of the runtime's library. */
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
        return std::string(option()) + " needs the library '" + library + "': " + std::strerror(errno) +
               "; builds with a sanitizer do not have it";
    const char* const before = std::getenv("LD_PRELOAD");
    const std::string others = before ? before : "";
    setenv(kExecutedAnew, ("=" + others).c_str(), 1);
    setenv("LD_PRELOAD", (others.empty() ? library : library + ":" + others).c_str(), 1);
    const std::string program = thisProgram();
    execv(program.c_str(), words);
    return std::string(option()) + " cannot execute '" + program + "' anew: " + std::strerror(errno);
}

/** Restores the environment, so that programs started by components are not checked. */
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

struct Fault {
    const char* code;
    const char* verb;
};

Fault describeForReplay(oroforge_rt_fault fault) {
    if (fault == OROFORGE_RT_CLOCK) return {"RPL008", "reads a clock of the computer"};
    if (fault == OROFORGE_RT_THREAD) return {"RPL010", "begins a thread"};
    if (fault == OROFORGE_RT_RANDOM) return {"RPL016", "takes random numbers"};
    if (fault == OROFORGE_RT_DEVICE) return {"RPL017", "opens a device"};
    return {"RPL009", "waits"};
}

Fault describe(oroforge_rt_fault fault) {
    if (checkedFor == CheckedFor::Replay) return describeForReplay(fault);
    switch (fault) {
        case OROFORGE_RT_ALLOCATION: return {"RTC001", "allocates memory"};
        case OROFORGE_RT_RELEASE: return {"RTC002", "frees memory"};
        case OROFORGE_RT_LOCK: return {"RTC003", "takes a lock"};
        case OROFORGE_RT_WAIT: return {"RTC004", "waits"};
        case OROFORGE_RT_THREAD:
        case OROFORGE_RT_SYSTEM_CALL: return {"RTC005", "makes a system call that may block"};
        case OROFORGE_RT_CLOCK:
        case OROFORGE_RT_RANDOM:
        case OROFORGE_RT_DEVICE:
        case OROFORGE_RT_STREAM: break;
    }
    return {"RTC006", "uses a stream of the C library"};
}

std::string times(unsigned long count, const char* one, const char* many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

/** Not a sink, which would drop the second of two places with the same message. */
using Findings = std::vector<RealTimeFinding>;

/** Of "file:line". */
oroforge::diag::Location locationIn(const std::string& place) {
    const std::size_t colon = place.rfind(':');
    if (colon == std::string::npos) return {};
    return {place.substr(0, colon), static_cast<unsigned>(std::strtoul(place.c_str() + colon + 1, nullptr, 10)), 0};
}

void add(void* to, const oroforge_rt_finding* finding) {
    RealTimeFinding made;
    const Fault fault = describe(finding->fault);
    made.component = finding->component;
    made.where = kPlaces[finding->place].where;
    made.verb = fault.verb;
    made.code = fault.code;
    made.function = finding->function;
    made.count = finding->count;
    made.script = locationIn(finding->script);
    for (unsigned i = 0; i != finding->depth; ++i) made.frames.push_back({{}, finding->frames[i], {}});
    static_cast<Findings*>(to)->push_back(std::move(made));
}

/** "300 executions of updateHook(), 2 of scripts"; empty if there were none. */
std::string executions(const oroforge_rt_totals& totals) {
    std::string text;
    for (int place = 0; place != OROFORGE_RT_PLACES; ++place) {
        const unsigned long count = totals.executions[place];
        if (count == 0) continue;
        text += text.empty() ? times(count, "execution", "executions") : ", " + std::to_string(count);
        text += std::string(" of ") + kPlaces[place].many;
    }
    return text;
}

/** The place at the end of "'function()' (file+0x1234)" or "file+0x1234"; without a file if there is none. */
std::pair<std::string, unsigned long> placeIn(const std::string& frame) {
    const std::size_t plus = frame.rfind("+0x");
    if (plus == std::string::npos) return {};
    std::size_t begin = 0;
    if (frame[0] == '\'') begin = frame.find("' (", 1) + 3;
    return {frame.substr(begin, plus - begin), std::strtoul(frame.c_str() + plus + 1, nullptr, 16)};
}

/** Adds file and line to frames for which there is debug information. */
void addPlaces(Findings& found) {
    SourceLines lines;
    const auto forEachFrame = [&found](const auto& visit) {
        for (RealTimeFinding& finding : found)
            for (oroforge::diag::Note& frame : finding.frames) visit(frame, placeIn(frame.message));
    };
    forEachFrame([&lines](const auto&, const auto& place) {
        if (!place.first.empty()) lines.want(place.first, place.second);
    });
    lines.find();
    forEachFrame([&lines](oroforge::diag::Note& frame, const auto& place) {
        if (place.first.empty()) return;
        const SourceLines::Place& known = lines.at(place.first, place.second);
        frame.where = known.where;
        // The library does not export the function.
        if (frame.message[0] != '\'' && !known.function.empty())
            frame.message = "'" + known.function + "' (" + frame.message + ")";
    });
}

}  // namespace

std::string startRealTimeCheck(char** words, CheckedFor what) {
    checkedFor = what;
    const char* const anew = std::getenv(kExecutedAnew);
    if (!anew) return executeAnew(words);
    restoreEnvironment(anew + 1);
    find(beginWatch, "oroforge_rt_check_begin");
    find(endWatch, "oroforge_rt_check_end");
    find(findings, "oroforge_rt_check_findings");
    find(describeScripts, "oroforge_rt_check_scripts");
    decltype(&oroforge_rt_check_only) countOnly = nullptr;
    find(countOnly, "oroforge_rt_check_only");
    if (!beginWatch || !endWatch || !findings || !describeScripts || !countOnly)
        return std::string(option()) + ": the system did not load '" + libraryFile() +
               "' before the program, as it refuses for programs with capabilities or another user's rights; run "
               "without these, as root, or with a limit for real-time priorities instead";
    if (what == CheckedFor::Replay)
        countOnly(1U << OROFORGE_RT_WAIT | 1U << OROFORGE_RT_CLOCK | 1U << OROFORGE_RT_THREAD |
                  1U << OROFORGE_RT_RANDOM | 1U << OROFORGE_RT_DEVICE);
    RTT::internal::ScriptPlace::wantExact();
    describeScripts(&RTT::internal::ScriptPlace::describe);
    HookInProgress::setWatch(&kWatch);
    return {};
}

bool reportRealTimeCheck(ProgramReport& report) {
    const std::string& program = report.program();
    HookInProgress::setWatch(nullptr);
    describeScripts(nullptr);
    Findings calls;
    const oroforge_rt_totals totals = findings(&add, &calls);
    addPlaces(calls);
    // What the runtime does by itself, as for a line of the log, changes nothing.
    if (checkedFor == CheckedFor::Replay)
        calls.erase(std::remove_if(calls.begin(), calls.end(), &isOfRuntime), calls.end());
    const std::vector<oroforge::diag::Diagnostic> found = arranged(calls);
    oroforge::diag::SourceCache sources;
    for (const oroforge::diag::Diagnostic& finding : found) {
        oroforge::diag::print(std::cerr, finding, sources);
        report.add(finding);
    }
    if (std::any_of(found.begin(), found.end(), &lacksLines))
        std::cerr << program << ": note: " << option()
                  << " knows no lines for some of these: they are shown for libraries that are built "
                     "with debug information (-g, or CMAKE_BUILD_TYPE RelWithDebInfo), if the program addr2line of "
                     "binutils is there\n";
    if (totals.lost != 0)
        std::cerr << program << ": warning: " << option() << " had no room for "
                  << times(totals.lost, "more call", "more calls") << "\n";
    const std::string executed = executions(totals);
    if (executed.empty() && checkedFor == CheckedFor::RealTime)
        std::cerr << program << ": warning: --rt-check saw no updateHook() of a component with a real-time scheduler\n";
    else
        std::cerr << program << ": " << option() << ": " << times(found.size(), "finding", "findings") << " in "
                  << executed << "\n";
    return found.empty();
}

}  // namespace OCL::deploy
