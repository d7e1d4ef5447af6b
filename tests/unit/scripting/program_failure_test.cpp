// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Programs: failures of statements and operations, and what the commands do then.
#include "program_fixture.hpp"

#include <unit/flow/log_capture.hpp>

using namespace RTT;
using oroforge::test::Probe;
using script_test::Programs;

namespace {

TEST_F(Programs, AFailureIsReportedWithItsPlace) {
    flow_test::LogCapture log;
    load("// comment\nprogram p {\n  count = 1\n  fail()\n  count = 2\n}");
    EXPECT_TRUE(p().start());
    step();
    EXPECT_EQ(status(), "error");
    EXPECT_TRUE(p().inError());
    EXPECT_EQ(count, 1);
    EXPECT_EQ(p().getLineNumber(), 4);
    const std::string error =
        "bench.ops:4:3: error: [OPS400] program 'p' of component 'host' failed: the gripper is stuck";
    EXPECT_EQ(p().getError(), error);
    EXPECT_TRUE(log.contains(error + "\n  fail()\n  ^")) << log.text();
    EXPECT_TRUE(host.inException()) << "the operation is its own";
    step(2);
    EXPECT_EQ(count, 1);
}

TEST_F(Programs, AnOperationOfTheirOwnComponentThatThrowsHasThemStandStill) {
    ASSERT_EQ(bench.load("program p {\n  try fail() catch count = 5\n  count = count + 1\n}\n"
                         "program q {\n  while true { note(\"q\"); yield }\n}"),
              "");
    EXPECT_TRUE(bench["q"].start());
    step();
    EXPECT_TRUE(p().start());
    step(4);
    EXPECT_TRUE(host.inException());
    EXPECT_EQ(count, 0) << "not even 'catch' is executed";
    EXPECT_EQ(status(), "running");
    const std::string before = notes;
    step(3);
    EXPECT_EQ(notes, before) << "nor is another program";
    EXPECT_TRUE(host.recover());
    step();
    EXPECT_EQ(count, 6);
    EXPECT_EQ(status(), "stopped");
    EXPECT_EQ(notes, before + "q");
}

TEST_F(Programs, AnOperationOfAnotherComponentThatThrowsIsCaughtAndPutsThatIntoException) {
    Probe other("other");
    other.addOperation("fail", [] { throw std::runtime_error("no power"); });
    ASSERT_TRUE(host.addPeer(&other));
    load("program p {\n  try other.fail() catch count = 5\n  count = count + 1\n  other.fail()\n}");
    EXPECT_TRUE(p().start());
    step();
    EXPECT_EQ(count, 6);
    EXPECT_TRUE(other.inException());
    EXPECT_FALSE(host.inException());
    EXPECT_EQ(status(), "error") << "of what is not caught";
    host.removePeer("other");
}

TEST_F(Programs, CommandsOfAFailedOne) {
    load("program p {\n  count = count + 1\n  fail()\n  count = 10\n}");
    EXPECT_TRUE(p().start());
    step();
    EXPECT_TRUE(host.recover());
    EXPECT_FALSE(p().start());
    EXPECT_FALSE(p().step());
    EXPECT_EQ(status(), "error");
    EXPECT_TRUE(p().pause());
    EXPECT_EQ(status(), "paused");
    EXPECT_EQ(p().getError(), "");
    EXPECT_EQ(p().getLineNumber(), 3);
    EXPECT_TRUE(p().start()) << "tries the statement again";
    step();
    EXPECT_EQ(status(), "error");
    EXPECT_TRUE(host.recover());
    EXPECT_TRUE(p().pause());
    broken = false;
    EXPECT_TRUE(p().start());
    step();
    EXPECT_EQ(status(), "stopped");
    EXPECT_EQ(count, 10);
    broken = true;
    EXPECT_TRUE(p().start());
    step();
    EXPECT_TRUE(p().stop());
    EXPECT_EQ(status(), "stopped");
    EXPECT_EQ(p().getError(), "");
}

TEST_F(Programs, ABudgetEndsALoopWithoutYield) {
    load("program p {\n  while true {\n    count = count + 1\n  }\n}");
    bench.budget->set(1000);
    EXPECT_TRUE(p().start());
    step();
    EXPECT_EQ(status(), "error");
    EXPECT_EQ(count, 1000);
    EXPECT_EQ(
        p().getError(),
        "bench.ops:3:5: error: [OPS400] program 'p' of component 'host' failed: the loop went round 1000 times in one "
        "step of the component, which is the limit; add a 'yield' to it");
}

}  // namespace
