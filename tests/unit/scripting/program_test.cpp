// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Programs: what a step executes, what the commands do in each state.
#include "program_fixture.hpp"

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;
using script_test::Programs;
using script_test::ScriptBench;

namespace {

TEST_F(Programs, RunUntilEachYieldInOneStep) {
    load("program p {\n  count = 1\n  count = 2\n  yield\n  count = 3\n}");
    EXPECT_EQ(status(), "stopped");
    step(2);
    EXPECT_EQ(count, 0) << "is not started by being loaded";
    EXPECT_TRUE(p().start());
    EXPECT_TRUE(p().isRunning());
    EXPECT_EQ(count, 0) << "the engine executes it";
    step();
    EXPECT_EQ(count, 2);
    EXPECT_EQ(p().getLineNumber(), 5);
    EXPECT_TRUE(p().isRunning());
    step();
    EXPECT_EQ(count, 3);
    EXPECT_TRUE(p().isStopped());
    EXPECT_EQ(p().getLineNumber(), 0);
    step();
    EXPECT_EQ(count, 3);
}

TEST_F(Programs, NothingEndsTheStepAsYieldDoes) {
    load("program p {\n  while count == 0 do nothing\n  count = 2\n  if count == 2 then nothing\n  count = 3\n}");
    EXPECT_TRUE(p().start());
    step(3);
    EXPECT_TRUE(p().isRunning());
    count = 1;
    step();
    EXPECT_EQ(count, 2);
    step();
    EXPECT_EQ(count, 3);
    EXPECT_TRUE(p().isStopped());
}

TEST_F(Programs, NothingInALoopLeavesTheStepBudget) {
    load("program p {\n  while count < 50 { count = count + 1; nothing }\n}");
    bench.budget->set(10);
    EXPECT_TRUE(p().start());
    step(51);
    EXPECT_EQ(status(), "stopped");
    EXPECT_EQ(count, 50);
}

TEST_F(Programs, BeginAnewWithTheirInitialisers) {
    load(
        "program p {\n  var int kept\n  var int fresh = 5\n  kept = kept + 1\n  fresh = fresh + 1\n  count = kept * 10 "
        "+ fresh\n}");
    EXPECT_TRUE(p().start());
    step();
    EXPECT_EQ(count, 16);
    EXPECT_TRUE(p().start());
    step();
    EXPECT_EQ(count, 26);
}

TEST_F(Programs, CommandsOfAStoppedOne) {
    load("program p {\n  count = 1\n}");
    EXPECT_FALSE(p().step());
    EXPECT_TRUE(p().stop());
    EXPECT_TRUE(p().pause());
    EXPECT_EQ(status(), "stopped");
    step();
    EXPECT_EQ(status(), "paused");
    EXPECT_EQ(p().getLineNumber(), 2);
    EXPECT_EQ(count, 0);
    EXPECT_TRUE(p().stop());
    EXPECT_EQ(status(), "stopped");
    EXPECT_TRUE(p().pause());
    EXPECT_TRUE(p().start());
    step();
    EXPECT_EQ(count, 1);
    EXPECT_EQ(status(), "stopped");
}

TEST_F(Programs, CommandsOfARunningOne) {
    load("program p {\n  while true {\n    count = count + 1\n    yield\n  }\n}");
    EXPECT_TRUE(p().start());
    step();
    EXPECT_FALSE(p().start());
    EXPECT_FALSE(p().step());
    EXPECT_TRUE(p().pause());
    EXPECT_EQ(status(), "running") << "until the next step";
    step(3);
    EXPECT_EQ(status(), "paused");
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(p().pause());
    EXPECT_TRUE(p().start());
    step();
    EXPECT_EQ(count, 2);
    EXPECT_TRUE(p().stop());
    EXPECT_EQ(status(), "stopped");
    step(2);
    EXPECT_EQ(count, 2);
}

TEST_F(Programs, APauseThatWasNotMadeYetIsTakenBackByStart) {
    load("program p {\n  while true {\n    count = count + 1\n    yield\n  }\n}");
    EXPECT_TRUE(p().start() && p().pause() && p().start());
    step(2);
    EXPECT_EQ(status(), "running");
    EXPECT_EQ(count, 2);
}

TEST_F(Programs, StepMayFollowAPauseThatWasNotMadeYet) {
    load("program p {\n  count = 1\n  yield\n  count = 2\n  count = 3\n  yield\n  count = 4\n}");
    EXPECT_TRUE(p().start());
    step();
    EXPECT_TRUE(p().pause() && p().step());
    EXPECT_FALSE(p().step()) << "the last one is still to come";
    step(2);
    EXPECT_EQ(status(), "paused");
    EXPECT_EQ(count, 2);
    EXPECT_TRUE(p().start() && p().pause() && p().step() && p().start()) << "takes both back";
    step();
    EXPECT_EQ(status(), "running");
    EXPECT_EQ(count, 3);
    EXPECT_TRUE(p().stop() && p().pause() && p().step());
    EXPECT_EQ(status(), "stopped");
    step();
    EXPECT_EQ(status(), "paused");
    EXPECT_EQ(p().getLineNumber(), 3);
    EXPECT_EQ(count, 1);
}

TEST_F(Programs, PauseAndStepByOneOfTheirStatements) {
    host.addOperation("halt", [this] { return p().pause() && p().step(); });
    load("program p {\n  halt()\n  count = 1\n  count = 2\n}");
    EXPECT_TRUE(p().start());
    step(2);
    EXPECT_EQ(status(), "paused");
    EXPECT_EQ(count, 1);
    EXPECT_EQ(p().getLineNumber(), 4);
}

TEST_F(Programs, StepExecutesOneStatement) {
    load("program p {\n  count = 1\n  count = 2\n  count = 3\n}");
    EXPECT_TRUE(p().pause());
    step();
    for (int statement = 1; statement <= 3; ++statement) {
        EXPECT_EQ(p().getLineNumber(), statement + 1);
        EXPECT_TRUE(p().step());
        EXPECT_FALSE(p().step()) << "the last one is still to come";
        EXPECT_EQ(count, statement - 1);
        step();
        EXPECT_EQ(count, statement);
        EXPECT_EQ(status(), statement == 3 ? "stopped" : "paused");
        step();
        EXPECT_EQ(count, statement);
    }
}

TEST_F(Programs, MayStopAndPauseThemselves) {
    host.addOperation("pauseIt", [this] { return p().pause(); });
    host.addOperation("stopIt", [this] { return p().stop(); });
    load("program p {\n  count = 1\n  pauseIt()\n  count = 2\n  stopIt()\n  count = 3\n}");
    EXPECT_TRUE(p().start());
    step();
    EXPECT_EQ(status(), "paused");
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(p().start());
    step();
    EXPECT_EQ(status(), "stopped");
    EXPECT_EQ(count, 2);
}

TEST_F(Programs, ThatAreStartedWithinAStepRunInItIfTheirTurnIsToCome) {
    load("program a { note(\"a\") }");
    load("program b { note(\"b\") }");
    load("program p { note(\"p\") }");
    scripting::ProgramInterface &a = bench["a"], &b = bench["b"];
    host.addOperation("startA", [&a] { return a.start(); });
    host.addOperation("startP", [this] { return p().start(); });
    load("program q { startA()\n startP() }");
    load("program r { note(\"r\") }");
    scripting::ProgramInterface& r = bench["r"];
    step(3);
    EXPECT_TRUE(r.start() && b.start() && p().start());
    step();
    EXPECT_EQ(notes, "bpr") << "in the order in which they were loaded";
    notes.clear();
    EXPECT_TRUE(bench["q"].start());
    step();
    EXPECT_EQ(notes, "") << "those in front of it have had their turn";
    step();
    EXPECT_EQ(notes, "ap");
    host.onUpdate = [&] { a.start(); };
    ASSERT_TRUE(host.start());
    step();
    host.onUpdate = nullptr;
    step(2);
    EXPECT_EQ(notes, "apa");
}

TEST_F(Programs, ObeyEveryCommandAfterTheyHadNothingToDoForLong) {
    load("program p {\n  count = count + 1\n  fail()\n  count = count + 10\n}");
    for (int round = 0; round != 3; ++round) {
        count = 0;
        broken = true;
        step(3);
        EXPECT_TRUE(p().start());
        step(3);
        EXPECT_EQ(status(), "error");
        EXPECT_TRUE(host.recover()) << "its own operation threw";
        EXPECT_TRUE(p().pause());
        step(3);
        EXPECT_TRUE(p().isPaused());
        broken = false;
        EXPECT_TRUE(p().step());
        EXPECT_FALSE(p().step()) << "the last one was not done yet";
        step(3);
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(p().step());
        step(3);
        EXPECT_EQ(count, 11);
        EXPECT_TRUE(p().isStopped()) << "that was its last";
        EXPECT_TRUE(p().start());
        step(3);
        EXPECT_TRUE(p().isStopped());
        EXPECT_TRUE(p().pause());
        step(3);
        EXPECT_TRUE(p().isPaused()) << "before its first statement";
        EXPECT_TRUE(p().start());
        step();
        EXPECT_EQ(count, 33);
    }
}

TEST_F(Programs, AreDeafWhileNoEngineHasThem) {
    load("program p {\n  count = 1\n}");
    ASSERT_TRUE(host.engine()->removeFunction(&p()));
    EXPECT_FALSE(p().start());
    EXPECT_FALSE(p().pause());
    EXPECT_FALSE(p().step());
    EXPECT_FALSE(p().stop());
    EXPECT_EQ(status(), "stopped");
    ASSERT_TRUE(host.engine()->runFunction(&p()));
    EXPECT_TRUE(p().start());
    step();
    EXPECT_EQ(count, 1);
}

TEST_F(Programs, MayBeDestroyedWhileTheyAreLoadedAndByThemselves) {
    load("program p {\n  count = 1\n  yield\n  count = 2\n}");
    host.addOperation("drop", [this] {
        bench["q"].stop();
        host.engine()->removeFunction(&bench["q"]);
        bench.programs.erase("q");
    });
    load("program q {\n  drop()\n  count = 100\n}");
    EXPECT_TRUE(p().start());
    step();
    bench.programs.erase("p");
    step();
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(bench["q"].start());
    step(2);
    EXPECT_EQ(count, 1) << "the statement that destroyed it was its last";
    EXPECT_TRUE(bench.programs.empty());
}

TEST_F(Programs, AreStoppedAndPausedByOtherThreadsInTheMiddleOfALoop) {
    Probe busy("busy");
    std::atomic<int> rounds{0};
    busy.addOperation("round", [&rounds] { ++rounds; });
    ScriptBench scripts(busy);
    ASSERT_EQ(scripts.load("program p {\n  while true\n    round()\n}"), "");
    scripting::ProgramInterface& endless = scripts["p"];
    ASSERT_TRUE(endless.start());
    ASSERT_TRUE(busy.trigger());
    ASSERT_TRUE(eventually([&] { return rounds > 10; }));
    EXPECT_TRUE(endless.pause());
    ASSERT_TRUE(eventually([&] { return endless.isPaused(); }));
    EXPECT_TRUE(endless.start());
    ASSERT_TRUE(busy.trigger());
    const int before = rounds;
    ASSERT_TRUE(eventually([&] { return rounds > before; }));
    EXPECT_TRUE(endless.stop());
    EXPECT_TRUE(endless.isStopped());
    EXPECT_TRUE(busy.getActivity()->stop()) << "its engine is free again";
}

TEST_F(Programs, AreCommandedByTheirService) {
    load("program p {\n  count = 1\n  yield\n  fail()\n}");
    const auto service = scripting::detail::makeProgramService(bench.programs["p"], host);
    EXPECT_EQ(service->getName(), "p");
    ASSERT_TRUE(host.provides()->addService(service));
    const auto call = [&](const char* name) {
        return OperationCaller<bool()>(host.provides("p")->getOperation(name), host.engine())();
    };
    EXPECT_TRUE(call("start"));
    EXPECT_TRUE(call("isRunning"));
    EXPECT_TRUE(call("pause"));
    step();
    EXPECT_TRUE(call("isPaused"));
    EXPECT_TRUE(call("step"));
    step();
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(call("start"));
    step(2);
    EXPECT_TRUE(call("inError"));
    EXPECT_TRUE(call("stop"));
    EXPECT_FALSE(call("isRunning") || call("isPaused") || call("inError"));
}

TEST_F(Programs, KeepTheirText) {
    const std::string text = "program p {\n  count = 1 // one\n}";
    load("\n" + text + "\n");
    EXPECT_EQ(p().getText(), text);
    EXPECT_EQ(p().getName(), "p");
}

}  // namespace
