// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Programs: what a step executes, what the commands do in each state, failures.
#include "script_bench.hpp"

#include <rtt/scripting/detail/program.hpp>
#include <unit/flow/log_capture.hpp>
#include <unit/operations/probe.hpp>
#include <unit/types/builtin_typekit.hpp>

#include <stdexcept>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;
using script_test::ScriptBench;

namespace {

/** A component whose steps are made by step(), with a variable and operations for the script. */
struct Programs : types_test::WithBuiltinTypes {
    Programs() {
        oroforge::test::makeManual(host);
        host.addAttribute("count", count);
        host.addOperation("note", [this](const std::string& text) { notes += text; });
        host.addOperation("fail", [this] {
            if (broken) throw std::runtime_error("the gripper is stuck");
        });
    }
    void step(int times = 1) {
        for (int i = 0; i != times; ++i) ASSERT_TRUE(host.update());
    }
    void load(const std::string& text) { ASSERT_EQ(bench.load(text), ""); }
    scripting::ProgramInterface& p() { return bench["p"]; }
    std::string status() { return p().getProgramStatusStr(); }

    Probe host{"host"};
    int count = 0;
    std::string notes;
    bool broken = true;
    ScriptBench bench{host};
};

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
    EXPECT_FALSE(host.inException());
    step(2);
    EXPECT_EQ(count, 1);
}

TEST_F(Programs, CommandsOfAFailedOne) {
    load("program p {\n  count = count + 1\n  fail()\n  count = 10\n}");
    EXPECT_TRUE(p().start());
    step();
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
