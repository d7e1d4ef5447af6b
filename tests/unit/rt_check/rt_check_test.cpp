// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// deployer --rt-check as a user runs it.
#include "../deployer/deployer_program.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <unistd.h>

namespace {

using namespace oroforge::test;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string element(const std::string& name, const std::string& type, const std::string& value) {
    return "<simple name='" + name + "' type='" + type + "'><value>" + value + "</value></simple>";
}

std::string list(const std::string& name, const std::string& type, const std::string& content) {
    return "<struct name='" + name + "' type='" + type + "'>" + content + "</struct>";
}

std::string activity(const std::string& scheduler, int priority, const std::string& period) {
    return list("Activity", "Activity",
                element("Period", "double", period) + element("Priority", "short", std::to_string(priority)) +
                    element("Scheduler", "string", scheduler));
}

std::string component(const std::string& name, const std::string& content) {
    std::string type = name;
    type[0] = static_cast<char>(std::toupper(type[0]));
    return list(name, "plantedfaults::" + type, content + element("AutoStart", "boolean", "1"));
}

std::string realTime(const std::string& name, const std::string& more = "") {
    return component(name, activity("ORO_SCHED_RT", 10, "0.001") + more);
}

std::string application(const std::string& components) {
    return "<properties>" + element("Import", "string", "plantedfaults") + components +
           component("teller", activity("ORO_SCHED_OTHER", 0, "0.02")) + "</properties>";
}

class RtCheck : public deployer_test::DeployerInDirectory {
protected:
    /** Runs these components until they have done their work. */
    Outcome check(const std::string& components, std::vector<std::string> words = {"--rt-check"}) {
        directory_.write("app.xml", application(components));
        words.insert(words.end(), {"-s", "app.xml"});
        return runUntil("all is done", words, SIGTERM);
    }

    /** The message that says so, with its notes; empty if there is none. */
    static std::string finding(const Outcome& outcome, const std::string& text) {
        const std::size_t begin = outcome.err.find(text);
        if (begin == std::string::npos) return {};
        const std::size_t next = outcome.err.find("error: ", begin + 1);
        return outcome.err.substr(begin, std::min(next, outcome.err.find(": --rt-check: ", begin)) - begin);
    }

    static std::ptrdiff_t errors(const Outcome& outcome) {
        std::ptrdiff_t count = 0;
        for (std::size_t at = 0; (at = outcome.err.find("error: [RTC", at)) != std::string::npos; ++at) ++count;
        return count;
    }
};

struct Planted {
    const char* component;
    const char* message;  // after the component's name
};

class RtCheckFault : public RtCheck, public testing::WithParamInterface<Planted> {};

TEST_P(RtCheckFault, IsReportedWithItsNumberAndPlace) {
    const std::string name = GetParam().component;
    const Outcome outcome = check(realTime(name));
    EXPECT_EQ(255, outcome.status);
    const std::string message = std::string(GetParam().message);
    const std::size_t code = message.find(' ');
    std::string type = name;
    type[0] = static_cast<char>(std::toupper(type[0]));
    const std::string found = finding(outcome, "error: [" + message.substr(0, code) + "] component '" + name + "'" +
                                                   message.substr(code) + ", 10 times\n");
    // The last frame is the component's: neither we nor what led to it is shown.
    EXPECT_THAT(found, ContainsRegex(
                           "plantedfaults\\.cpp:[0-9]+: note: called by '"
                           "(virtual thunk to )?plantedfaults::" +
                           type + "::(work|updateHook)\\(\\)' \\([^)]*libplantedfaults-[^)]*\\.so\\+0x[0-9a-f]+\\)\n"))
        << outcome.err;
    EXPECT_THAT(found, AllOf(Not(HasSubstr("liborocos-rtcheck")), Not(HasSubstr("ExecutionEngine"))));
}

INSTANTIATE_TEST_SUITE_P(
    EachClass, RtCheckFault,
    testing::Values(Planted{"allocator", "RTC001 allocates memory in updateHook(): malloc()"},
                    Planted{"releaser", "RTC002 frees memory in updateHook(): free()"},
                    Planted{"locker", "RTC003 takes a lock in updateHook(): pthread_mutex_lock()"},
                    Planted{"sleeper", "RTC004 waits in updateHook(): usleep()"},
                    Planted{"writer", "RTC005 makes a system call that may block in updateHook(): write()"},
                    Planted{"opener", "RTC005 makes a system call that may block in updateHook(): open()"},
                    Planted{"printer", "RTC006 uses a stream of the C library in updateHook(): fwrite()"}),
    [](const auto& info) { return std::string(info.param.component); });

TEST_F(RtCheck, EachComponentIsToldOfByItself) {
    const Outcome outcome = check(realTime("sleeper") + realTime("locker") + realTime("clean"));
    EXPECT_EQ(255, outcome.status);
    EXPECT_EQ(2, errors(outcome)) << outcome.err;
    EXPECT_LT(outcome.err.find("component 'locker'"), outcome.err.find("component 'sleeper'"));
    EXPECT_THAT(outcome.err, ContainsRegex("--rt-check: 2 findings in [0-9]+ executions of updateHook\\(\\)\n"));
}

TEST_F(RtCheck, FindingsAreInTheDocumentOfAFormat) {
    directory_.write("app.xml", application(realTime("sleeper")));
    Command shell = command({"-c", "sleep 2 | \"$0\" --rt-check --format=json -s app.xml", DEPLOYER_PROGRAM});
    shell.program = "/bin/sh";
    const Outcome outcome = run(shell);
    EXPECT_EQ(255, outcome.status);
    const nlohmann::json found = nlohmann::json::parse(outcome.out)["diagnostics"];
    ASSERT_EQ(1u, found.size()) << outcome.out;
    EXPECT_EQ("RTC004", found[0]["code"]);
    EXPECT_THAT(found[0]["file"].get<std::string>(), testing::EndsWith("plantedfaults.cpp"));
    EXPECT_GT(found[0]["line"], 0);
    EXPECT_THAT(outcome.err, HasSubstr("--rt-check: 1 finding in "));
}

TEST_F(RtCheck, EachPlaceIsToldOfByItself) {
    const Outcome outcome = check(realTime("twoPlaces"));
    EXPECT_EQ(255, outcome.status);
    EXPECT_EQ(2, errors(outcome)) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("called by 'plantedfaults::TwoPlaces::one()'"),
                                   HasSubstr("called by 'plantedfaults::TwoPlaces::other()'")));
    EXPECT_THAT(outcome.err, ContainsRegex("--rt-check: 2 findings in [0-9]+ executions of updateHook\\(\\)\n"));
}

TEST_F(RtCheck, AWaitForAConditionIsReported) {
    const Outcome outcome = check(realTime("conditionWaiter"));
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, ContainsRegex("error: \\[RTC004\\] component 'conditionWaiter' waits in updateHook\\(\\): "
                                           "pthread_cond_[a-z]+\\(\\), 10 times\n"));
    EXPECT_EQ(1, errors(outcome)) << outcome.err;
}

TEST_F(RtCheck, AWaitForAnotherComponentIsReported) {
    const Outcome outcome =
        check(realTime("caller", list("Peers", "PropertyBag", "<simple type='string'><value>teller</value></simple>")));
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("error: [RTC004] component 'caller' waits in updateHook(): futex(), "));
    EXPECT_THAT(outcome.err, Not(ContainsRegex("RTC00[12356]")));
}

TEST_F(RtCheck, WhatTheRuntimeDoesAboutAnExceptionIsNotReported) {
    const Outcome outcome = check(realTime("thrower"));
    EXPECT_EQ(255, outcome.status);
    EXPECT_EQ(1, errors(outcome)) << outcome.err;
    EXPECT_THAT(finding(outcome, "error: [RTC001] component 'thrower'"), HasSubstr("__cxa_allocate_exception"));
}

TEST_F(RtCheck, NothingIsReportedOfComponentsThatDoNothingOfIt) {
    directory_.write("count.osd",
                     "StateMachine Count { initial state counting { run { set count = count + 1 } } "
                     "final state end { } }\nRootMachine Count machine\n");
    directory_.write("begin.ops", "program p { while (true) { set count = count + 1; yield } }\np.start()\n");
    const std::string wire = "<struct name='wire' type='ConnPolicy'>" + element("type", "short", "0") + "</struct>";
    const std::string ports =
        list("Ports", "PropertyBag", element("in", "string", "wire") + element("out", "string", "wire")) +
        element("StateMachineScript", "string", "count.osd") + element("RunScript", "string", "begin.ops");
    const Outcome outcome = check(wire + realTime("clean", ports));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_EQ(0, errors(outcome)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("logged by clean"));
    EXPECT_THAT(outcome.err, ContainsRegex("--rt-check: 0 findings in [1-9][0-9]* executions of updateHook\\(\\), "
                                           "[1-9][0-9]* of scripts\n"));
}

TEST_F(RtCheck, WhateverTheThreadExecutesWhileTheComponentRunsIsWatched) {
    directory_.write("begin.ops", "program p { while (true) { do inScript(); yield } }\np.start()\n");
    const std::string wire = "<struct name='wire' type='ConnPolicy'>" + element("type", "short", "0") + "</struct>";
    const std::string eachPlace =
        activity("ORO_SCHED_RT", 10, "0.001") + list("Ports", "PropertyBag", element("in", "string", "wire"));
    const std::string idle = list("idle", "plantedfaults::EachPlace", activity("ORO_SCHED_RT", 10, "0.001"));
    const std::string mover = component("mover", activity("ORO_SCHED_OTHER", 0, "0.001") +
                                                     list("Ports", "PropertyBag", element("out", "string", "wire")) +
                                                     list("Peers", "PropertyBag",
                                                          "<simple type='string'><value>eachPlace</value></simple>"
                                                          "<simple type='string'><value>idle</value></simple>"));
    const Outcome outcome =
        check(wire + component("eachPlace", eachPlace + element("RunScript", "string", "begin.ops")) + idle + mover);
    EXPECT_EQ(255, outcome.status);
    const std::string one = "error: [RTC003] component 'eachPlace' takes a lock in ";
    const char* const places[][2] = {{"errorHook()", "errorHook"},
                                     {"the callback of a port", "inCallback"},
                                     {"an operation", "inOperation"},
                                     {"a script", "inScript"}};
    for (const auto& [place, function] : places)
        EXPECT_THAT(finding(outcome, one + place + ": pthread_mutex_lock(), "),
                    HasSubstr("called by 'plantedfaults::EachPlace::" + std::string(function) + "()'"))
            << place << "\n"
            << outcome.err;
    EXPECT_EQ(4, errors(outcome)) << outcome.err;  // and none of the one that is not started
    EXPECT_THAT(outcome.err, ContainsRegex("executions of updateHook\\(\\), [0-9]+ of errorHook\\(\\), [0-9]+ of "
                                           "callbacks of ports, [0-9]+ of operations, [0-9]+ of scripts\n"));
}

TEST_F(RtCheck, ComponentsWithoutARealTimeSchedulerAreNotWatched) {
    std::string faulty;
    for (const char* name : {"allocator", "releaser", "locker", "sleeper", "writer", "printer"})
        faulty += component(name, activity("ORO_SCHED_OTHER", 0, "0.001"));
    const Outcome outcome = check(faulty);
    EXPECT_EQ(0, outcome.status);
    EXPECT_EQ(0, errors(outcome)) << outcome.err;
    EXPECT_THAT(outcome.err,
                HasSubstr("warning: --rt-check saw no updateHook() of a component with a real-time scheduler\n"));
}

TEST_F(RtCheck, ASlaveIsWatchedAndAnswersForItself) {
    const std::string peers = list("Peers", "PropertyBag", "<simple type='string'><value>locker</value></simple>");
    const std::string slave = list("Activity", "SlaveActivity", element("Master", "string", "master"));
    const Outcome outcome = check(realTime("master", peers) + component("locker", slave));
    EXPECT_EQ(255, outcome.status);
    EXPECT_EQ(1, errors(outcome)) << outcome.err;
    EXPECT_THAT(finding(outcome, "error: [RTC003] component 'locker' takes a lock"), Not(HasSubstr("Master::")));
}

/** A machine on which nobody may have real-time threads. */
TEST_F(RtCheck, AComponentThatDidNotGetItsSchedulerIsWatchedAllTheSame) {
    directory_.write("app.xml", application(realTime("locker") + realTime("clean")));
    Command restricted = lasting({"--rtprio=0:0"});
    restricted.program = "prlimit";
    if (geteuid() == 0)
        restricted.arguments.insert(restricted.arguments.end(), {"setpriv", "--bounding-set=-sys_nice"});
    restricted.arguments.insert(restricted.arguments.end(), {DEPLOYER_PROGRAM, "--rt-check", "-s", "app.xml"});
    ChildProcess deployer(restricted);
    EXPECT_TRUE(deployer.waitForOutput("all is done", std::chrono::seconds(20)));
    deployer.send(SIGTERM);
    const Outcome outcome = deployer.finish();
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("using ORO_SCHED_OTHER"));
    EXPECT_THAT(outcome.err, HasSubstr("error: [RTC003] component 'locker' takes a lock"));
    EXPECT_THAT(outcome.err, HasSubstr("logged by clean"));
    EXPECT_EQ(1, errors(outcome)) << outcome.err;  // the log is used as a real-time thread uses it
}

TEST_F(RtCheck, WithoutTheOptionNothingIsWatchedOrPreloaded) {
    const Outcome outcome = check(realTime("locker"), {});
    EXPECT_EQ(0, outcome.status);
    EXPECT_THAT(outcome.err, Not(HasSubstr("rt-check")));
    EXPECT_EQ(0, errors(outcome));
}

TEST_F(RtCheck, RttscriptHasItToo) {
    directory_.write("app.xml", application(realTime("locker")));
    directory_.write("wait.ops", "waitForInterrupt()\n");
    Command script = command({"--rt-check", "-s", "app.xml", "wait.ops"});
    script.program = RTTSCRIPT_PROGRAM;
    ChildProcess program(script);
    EXPECT_TRUE(program.waitForOutput("waiting for an interrupt", std::chrono::seconds(20)));
    EXPECT_TRUE(program.waitForOutput("all is done", std::chrono::seconds(20)));
    program.send(SIGTERM);
    const Outcome outcome = program.finish();
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("error: [RTC003] component 'locker' takes a lock"));
}

TEST_F(RtCheck, ProgramsThatComponentsStartAreLeftAlone) {
    EXPECT_THAT(check(realTime("clean")).out, HasSubstr("preloaded: \n0\n"));
    directory_.write("app.xml", application(realTime("clean")));
    Command withAnother = lasting({"--rt-check", "-s", "app.xml"});
    withAnother.environment["LD_PRELOAD"] = "libm.so.6";
    ChildProcess deployer(withAnother);
    EXPECT_TRUE(deployer.waitForOutput("all is done", std::chrono::seconds(20)));
    deployer.send(SIGTERM);
    const Outcome outcome = deployer.finish();
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("preloaded: libm.so.6\n0\n"));
}

TEST_F(RtCheck, IsRefusedWhereNothingWouldRun) {
    directory_.write("app.xml", application(realTime("locker")));
    for (const char* option : {"--check", "--dry-run"}) {
        const Outcome outcome = run(command({"--rt-check", option, "-s", "app.xml"}));
        EXPECT_EQ(255, outcome.status);
        EXPECT_THAT(
            outcome.err,
            HasSubstr("error: --rt-check watches components that run, which --check and --dry-run do not start\n"));
    }
}

TEST_F(RtCheck, SaysThatItsLibraryCannotBeLoaded) {
    Command twice = command({"--rt-check", "-s", "app.xml"});
    twice.environment["OROFORGE_RT_CHECK_PRELOADED_BEFORE"] = "=";  // as if it had been executed anew, in vain
    const Outcome outcome = run(twice);
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, ContainsRegex("error: --rt-check: the system did not load '.*/liborocos-rtcheck-"));
}

}  // namespace
