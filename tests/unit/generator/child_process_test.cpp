// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <support/child_process.hpp>

#include <csignal>

#include <gtest/gtest.h>

namespace oroforge::test {
namespace {

using namespace std::chrono_literals;

Command shell(const std::string& script) {
    Command command;
    command.program = "sh";
    command.arguments = {"-c", script};
    return command;
}

TEST(ChildProcess, CollectsBothOutputsAndTheStatus) {
    const Outcome outcome = run(shell("echo out; echo err >&2; exit 3"));

    EXPECT_EQ(outcome.out, "out\n");
    EXPECT_EQ(outcome.err, "err\n");
    EXPECT_EQ(outcome.status, 3);
}

TEST(ChildProcess, PassesInputEnvironmentAndDirectory) {
    Command command = shell("cat; echo $COLOUR; pwd");
    command.input = "in\n";
    command.environment["COLOUR"] = "blue";
    command.directory = "/";

    EXPECT_EQ(run(command).out, "in\nblue\n/\n");
}

TEST(ChildProcess, LargeOutputDoesNotBlock) { EXPECT_EQ(run(shell("head -c 1000000 /dev/zero")).out.size(), 1000000U); }

TEST(ChildProcess, IsKilledAtItsTimeout) {
    Command command = shell("sleep 60");
    command.timeout = 100ms;

    const Outcome outcome = run(command);

    EXPECT_TRUE(outcome.timedOut);
    EXPECT_EQ(outcome.status, 128 + SIGKILL);
}

TEST(ChildProcess, ReceivesSignalsOnceItSpeaks) {
    ChildProcess child(shell("trap 'echo stopped; exit 5' TERM; echo ready; while :; do sleep 0.02; done"));

    ASSERT_TRUE(child.waitForOutput("ready", 10s));
    child.send(SIGTERM);

    const Outcome outcome = child.finish();
    EXPECT_EQ(outcome.status, 5);
    EXPECT_EQ(outcome.out, "ready\nstopped\n");
}

TEST(ChildProcess, UnknownProgramIs127) {
    Command command;
    command.program = "no-such-program-anywhere";

    EXPECT_EQ(run(command).status, 127);
}

}  // namespace
}  // namespace oroforge::test
