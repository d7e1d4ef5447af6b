// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/StartStopManager.hpp>
#include <rtt/os/startstop.h>

#include <support/child_process.hpp>

#include <gtest/gtest.h>
#include <string>

using namespace RTT;

namespace {

std::string calls;
int startA() { return calls += "a", 0; }
int startB() { return calls += "b", 0; }
int startFails() { return calls += "f", 3; }
void stopA() { calls += "A"; }
void stopB() { calls += "B"; }
void stopC() { calls += "C"; }

oroforge::test::Outcome runProbe(std::vector<std::string> arguments, const char* program = ORO_MAIN_PROBE) {
    oroforge::test::Command command;
    command.program = program;
    command.arguments = std::move(arguments);
    command.environment["ORO_LOGFILE"] = "/dev/null";
    return oroforge::test::run(command);
}

}  // namespace

TEST(StartStop, FunctionsRunByPhaseAndOnce) {
    calls.clear();
    os::InitFunction late(&startB, os::StartPlugins);
    os::InitFunction early(&startA);
    os::CleanupFunction last(&stopC, os::StopPlugins);
    os::CleanupFunction first(&stopA);
    os::CleanupFunction beforeFirst(&stopB);
    char name[] = "prog";
    char* argv[] = {name, nullptr};
    EXPECT_EQ(__os_init(1, argv), 0);
    EXPECT_EQ(__os_init(1, argv), 0);
    EXPECT_EQ(calls, "ab");
    EXPECT_EQ(__os_main_argc(), 1);
    EXPECT_EQ(__os_main_argv(), argv);
    __os_exit();
    __os_exit();
    EXPECT_EQ(calls, "abBAC");
}

TEST(StartStop, LateFunctionRunsAtOnce) {
    calls.clear();
    EXPECT_EQ(__os_init(0, nullptr), 0);
    os::InitFunction late(&startA);
    EXPECT_EQ(calls, "a");
    __os_exit();
}

TEST(StartStop, FailureIsReported) {
    calls.clear();
    os::InitFunction fails(&startFails);
    os::InitFunction never(&startA, os::StartPlugins);
    EXPECT_EQ(__os_init(0, nullptr), 3);
    EXPECT_EQ(calls, "f");
    __os_exit();
}

TEST(StartStop, GoneObjectsAreForgotten) {
    calls.clear();
    { os::InitFunction gone(&startA); }
    { os::CleanupFunction gone(&stopA); }
    EXPECT_EQ(__os_init(0, nullptr), 0);
    __os_exit();
    EXPECT_EQ(calls, "");
}

TEST(StartStop, StaticObjectsOfTheProgramMayEndTheRuntime) {
    const auto outcome = runProbe({}, STATIC_RUNTIME_PROBE);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, "ended\n");
}

TEST(OroMain, ReturnsTheResultOfTheBody) {
    const auto outcome = runProbe({"return", "7"});
    EXPECT_EQ(outcome.status, 7);
    EXPECT_EQ(outcome.out, "argc 3\n");
}

TEST(OroMain, ReportsAnException) {
    const auto outcome = runProbe({"throw"});
    EXPECT_EQ(outcome.status, 255);
    EXPECT_NE(outcome.err.find("ORO_main() was left by an exception: boom"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("--nocatch"), std::string::npos);
    EXPECT_EQ(runProbe({"throwInt"}).status, 255);
}

TEST(OroMain, NoCatchLetsItThrough) {
    EXPECT_EQ(runProbe({"throw", "--nocatch"}).status, 128 + 6);
    EXPECT_EQ(runProbe({"throw", "--no-catch"}).status, 128 + 6);
    EXPECT_EQ(runProbe({"return", "0", "--nocatch"}).out, "argc 3\n");
    EXPECT_EQ(runProbe({"return", "0", "--nocatch", "x"}).out, "argc 5\n");
}
