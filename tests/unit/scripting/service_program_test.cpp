// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The programs that the scripting service keeps.
#include "service_host.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/extras/SimulationActivity.hpp>

#include <gmock/gmock.h>
#include <thread>

namespace {

using RTT::scripting::ProgramInterface;
using service_test::Host;
using service_test::ServiceTest;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

const char* const kCounting = "program counting {\n  while (true) {\n    count = count + 1\n    yield\n  }\n}\n";

class ProgramsOfService : public ServiceTest {};

/** As users write them. */
class Ticking : public ProgramInterface {
public:
    const std::string& getName() const override { return name_; }
    bool start() override { return status_ == Status::stopped && change(Status::running); }
    bool pause() override { return change(Status::paused); }
    bool step() override { return false; }
    bool stop() override { return change(Status::stopped); }
    ProgramStatus getStatus() const override { return status_; }
    int getLineNumber() const override { return 1; }
    bool execute() override {
        if (status_ == Status::running) ++ticks;
        return true;
    }

    int ticks = 0;

private:
    bool change(ProgramStatus status) {
        status_ = status;
        return true;
    }
    std::string name_ = "ticking";
    ProgramStatus status_ = Status::stopped;
};

TEST_F(ProgramsOfService, AreExecutedByTheEngine) {
    ASSERT_TRUE(service->loadProgramText(kCounting));
    EXPECT_THAT(service->getProgramList(), ElementsAre("counting"));
    EXPECT_TRUE(service->hasProgram("counting"));
    EXPECT_EQ("stopped", service->getProgramStatusStr("counting"));
    EXPECT_TRUE(service->startProgram("counting"));
    EXPECT_TRUE(service->isProgramRunning("counting"));
    EXPECT_EQ(0, host.count);
    host.step(3);
    EXPECT_EQ(3, host.count);
    EXPECT_TRUE(service->pauseProgram("counting"));
    host.step(2);
    EXPECT_TRUE(service->isProgramPaused("counting"));
    EXPECT_EQ(ProgramInterface::Status::paused, service->getProgramStatus("counting"));
    EXPECT_EQ(3, host.count);
    EXPECT_TRUE(service->stopProgram("counting"));
    EXPECT_FALSE(service->isProgramRunning("counting"));
    EXPECT_EQ(kCounting, service->getProgramText("counting") + "\n");
}

TEST_F(ProgramsOfService, GiveTheirWholeTextWithTheCommentBeforeIt) {
    const std::string first =
        "// counts\n/* and nothing\n   else */\nprogram first {\n  // one\n  count = 1\n  fail()\n}";
    const std::string second = "# the second\n\nprogram second { count = 2 }";
    ASSERT_TRUE(service->loadProgramText(first + " // ends here\n\n" + second + "\n"));
    EXPECT_EQ(first, service->getProgramText("first"));
    EXPECT_EQ(second, service->getProgramText("second"));
    EXPECT_EQ(1, service->getProgram("first")->getFirstLine());
    EXPECT_EQ(10, service->getProgram("second")->getFirstLine());
    ASSERT_TRUE(eval("count = 3; program same { }  program line { }\n  // indented\n  program third { }\n"));
    EXPECT_EQ("program same { }", service->getProgramText("same"));
    EXPECT_EQ("program line { }", service->getProgramText("line"));
    EXPECT_EQ("// indented\n  program third { }", service->getProgramText("third"));
    logged();
    ASSERT_TRUE(service->startProgram("first"));
    host.step();
    EXPECT_EQ(7, service->getProgramLine("first"));
    EXPECT_THAT(logged(), testing::HasSubstr("string:7:3: error: [OPS400] program 'first' of component 'host' failed"));
}

TEST_F(ProgramsOfService, AreExecutedWhileTheComponentIsStopped) {
    ASSERT_TRUE(service->loadProgramText(kCounting));
    ASSERT_FALSE(host.isRunning());
    ASSERT_TRUE(service->startProgram("counting"));
    host.step(2);
    EXPECT_EQ(2, host.count);
}

TEST_F(ProgramsOfService, AreUnloadedAtOnceWhileTheSimulationMakesNoSteps) {
    ASSERT_TRUE(host.setActivity(new RTT::extras::SimulationActivity(0.001)));
    const auto thread = RTT::extras::SimulationThread::Instance();
    for (const bool byAnotherThread : {false, true}) {
        ASSERT_TRUE(service->loadProgramText(kCounting));
        ASSERT_TRUE(service->startProgram("counting"));
        const int before = host.count;
        ASSERT_TRUE(thread->run(3));
        EXPECT_EQ(before + 3, host.count);
        EXPECT_TRUE(service->stopProgram("counting"));
        bool unloaded = false;
        const auto unload = [&] { unloaded = service->unloadProgram("counting"); };
        byAnotherThread ? std::thread(unload).join() : unload();
        EXPECT_TRUE(unloaded);
        EXPECT_FALSE(service->hasProgram("counting"));
    }
    ASSERT_TRUE(host.setActivity(nullptr));
    RTT::extras::SimulationThread::Release();
}

TEST_F(ProgramsOfService, TellWhereTheyAre) {
    ASSERT_TRUE(eval("program p {\n  count = 1\n  count = 2\n  fail()\n}\n"));
    EXPECT_EQ(0, service->getProgramLine("p"));
    EXPECT_FALSE(service->stepProgram("p"));
    EXPECT_TRUE(service->pauseProgram("p"));
    host.step();
    EXPECT_EQ(2, service->getProgramLine("p"));
    EXPECT_TRUE(service->stepProgram("p"));
    host.step();
    EXPECT_EQ(1, host.count);
    EXPECT_EQ(3, service->getProgramLine("p"));
    EXPECT_TRUE(service->startProgram("p"));
    host.step();
    EXPECT_TRUE(service->inProgramError("p"));
    EXPECT_EQ("error", service->getProgramStatusStr("p"));
    EXPECT_EQ(4, service->getProgramLine("p"));
}

TEST_F(ProgramsOfService, ThatDoNotExistAreUnknown) {
    EXPECT_THAT(service->getProgramList(), IsEmpty());
    EXPECT_FALSE(service->hasProgram("p"));
    EXPECT_FALSE(service->getProgram("p"));
    EXPECT_FALSE(service->startProgram("p"));
    EXPECT_FALSE(service->stopProgram("p"));
    EXPECT_FALSE(service->pauseProgram("p"));
    EXPECT_FALSE(service->stepProgram("p"));
    EXPECT_FALSE(service->isProgramRunning("p"));
    EXPECT_FALSE(service->isProgramPaused("p"));
    EXPECT_FALSE(service->inProgramError("p"));
    EXPECT_EQ("unknown", service->getProgramStatusStr("p"));
    EXPECT_EQ(ProgramInterface::Status::unknown, service->getProgramStatus("p"));
    EXPECT_EQ(-1, service->getProgramLine("p"));
    EXPECT_EQ("", service->getProgramText("p"));
}

TEST_F(ProgramsOfService, HaveNamesOfTheirOwn) {
    ASSERT_TRUE(eval("program p { }\n"));
    EXPECT_FALSE(eval("program p { }\n"));
    EXPECT_EQ(
        "eval():1:9: error: [OPS203] program 'p' cannot be loaded: component 'host' has a program of that "
        "name already\n"
        "program p { }\n"
        "        ^\n",
        logged());
    host.provides("arm");
    EXPECT_FALSE(eval("program arm { }\n"));
    EXPECT_THAT(logged(), StartsWith("eval():1:9: error: [OPS203] program 'arm' cannot be loaded: component 'host' "
                                     "has a service of that name already\n"));
}

TEST_F(ProgramsOfService, CanBeUnloadedAndLoadedAnew) {
    ASSERT_TRUE(eval(kCounting));
    ASSERT_TRUE(service->startProgram("counting"));
    host.step();
    EXPECT_TRUE(service->unloadProgram("counting"));
    EXPECT_FALSE(host.provides()->hasService("counting"));
    host.step();
    EXPECT_EQ(1, host.count);
    EXPECT_FALSE(service->hasProgram("counting"));
    EXPECT_TRUE(eval(kCounting));
    EXPECT_TRUE(host.provides()->hasService("counting"));
}

TEST_F(ProgramsOfService, ThatAreNotThereCannotBeUnloaded) {
    ASSERT_TRUE(eval(kCounting));
    EXPECT_FALSE(service->unloadProgram("countin"));
    EXPECT_EQ("ERROR: program 'countin' cannot be unloaded: there is none of that name; did you mean 'counting'?\n",
              logged());
}

TEST_F(ProgramsOfService, MayUnloadThemselves) {
    ASSERT_TRUE(eval("program p {\n count = 1\n scripting.unloadProgram(\"p\")\n count = 2\n}\n"));
    ASSERT_TRUE(service->startProgram("p"));
    host.step(2);
    EXPECT_EQ(1, host.count);
    EXPECT_FALSE(service->hasProgram("p"));
    ASSERT_TRUE(eval("program p { count = 3 }\n"));
    ASSERT_TRUE(service->startProgram("p"));
    host.step();
    EXPECT_EQ(3, host.count);
    EXPECT_TRUE(service->unloadProgram("p"));
}

TEST_F(ProgramsOfService, MayBeWrittenInCpp) {
    const auto program = boost::make_shared<Ticking>();
    ASSERT_TRUE(service->loadProgram(program));
    EXPECT_EQ(program, service->getProgram("ticking"));
    EXPECT_FALSE(service->loadProgram(program));
    EXPECT_EQ("ERROR: program 'ticking' cannot be loaded: component 'host' has a program of that name already\n",
              logged());
    RTT::OperationCaller<bool()> start(host.provides("ticking")->getOperation("start"));
    ASSERT_TRUE(start.ready());
    EXPECT_TRUE(start());
    host.step(2);
    EXPECT_EQ(2, program->ticks);
    EXPECT_TRUE(service->unloadProgram("ticking"));
    EXPECT_FALSE(program->isLoaded());
    host.step();
    EXPECT_EQ(2, program->ticks);
}

TEST_F(ProgramsOfService, AComponentInFatalErrorTakesNone) {
    host.breakDown();
    EXPECT_FALSE(eval("program p { }\n"));
    EXPECT_EQ("ERROR: program 'p' cannot be loaded: the engine of component 'host' does not take it\n", logged());
    EXPECT_FALSE(host.provides()->hasService("p"));
}

TEST_F(ProgramsOfService, AComponentWithoutPeriodIsWarnedOf) {
    RTT::TaskContext idle("idle");
    const auto scripting = idle.getProvider<RTT::scripting::ScriptingService>("scripting");
    ASSERT_TRUE(scripting->eval("program p { }\n"));
    EXPECT_EQ(
        "Warning: program 'p' is executed only when something wakes component 'idle', which has no period: give it "
        "one with setPeriod(), or set scripting.ZeroPeriodWarning to false\n",
        logged());
    ASSERT_TRUE(scripting->eval("scripting.ZeroPeriodWarning = false\nprogram q { }\n"));
    EXPECT_THAT(logged(), IsEmpty());
}

TEST_F(ProgramsOfService, TheStepBudgetEndsALoopWithoutYield) {
    ASSERT_TRUE(eval("program endless {\n  while (true) {\n    count = count + 1\n  }\n}\n"));
    ASSERT_TRUE(eval("scripting.StepBudget = 1000\nendless.start()\n"));
    host.step();
    EXPECT_TRUE(service->inProgramError("endless"));
    EXPECT_GE(host.count, 999);
    EXPECT_LE(host.count, 1001);
    EXPECT_THAT(logged(), StartsWith("eval():3:5: error: [OPS400] program 'endless' of component 'host' failed: "
                                     "the loop went round 1000 times"));
}

TEST_F(ProgramsOfService, GoAwayWithTheirService) {
    ASSERT_TRUE(eval(kCounting));
    ASSERT_TRUE(service->startProgram("counting"));
    host.step();
    const auto program = service->getProgram("counting");
    service->clear();
    EXPECT_FALSE(program->isLoaded());
    EXPECT_FALSE(host.provides()->hasService("counting"));
    host.step();
    EXPECT_EQ(1, host.count);
}

TEST_F(ProgramsOfService, AComponentMayGoWhileTheyRun) {
    boost::shared_ptr<ProgramInterface> program;
    {
        Host gone("gone");
        const auto scripting = gone.getProvider<RTT::scripting::ScriptingService>("scripting");
        ASSERT_TRUE(scripting->eval(kCounting));
        ASSERT_TRUE(scripting->startProgram("counting"));
        gone.step();
        program = scripting->getProgram("counting");
    }
    EXPECT_FALSE(program->isLoaded());
}

TEST_F(ProgramsOfService, AServiceMayOutliveItsComponent) {
    RTT::scripting::ScriptingService::shared_ptr scripting;
    {
        Host gone("gone");
        scripting = gone.getProvider<RTT::scripting::ScriptingService>("scripting");
        ASSERT_TRUE(scripting->eval(kCounting));
    }
    EXPECT_FALSE(scripting->eval("count = 1"));
    EXPECT_EQ("ERROR: a script cannot be run: service 'scripting' belongs to no component\n", logged());
}

TEST_F(ProgramsOfService, OfATextWithAnErrorAreNotLoaded) {
    EXPECT_FALSE(service->loadProgramText("program p { }\nprogram q { cuont = 1 }\n"));
    EXPECT_THAT(service->getProgramList(), IsEmpty());
    EXPECT_TRUE(service->loadProgramText("program p { }\nprogram q { count = 1 }\n"));
    EXPECT_THAT(service->getProgramList(), ElementsAre("p", "q"));
}

TEST_F(ProgramsOfService, MayCommandEachOtherAndGo) {
    ASSERT_TRUE(eval("program p { }\nprogram q { p.start() }\n"));
    const boost::weak_ptr<ProgramInterface> first = service->getProgram("p"), second = service->getProgram("q");
    ASSERT_TRUE(service->unloadProgram("p"));
    ASSERT_TRUE(eval("program p { q.start() }\n"));
    EXPECT_TRUE(first.expired());
    ASSERT_TRUE(service->unloadProgram("q"));
    ASSERT_TRUE(eval("program q { p.start() }\n"));
    EXPECT_TRUE(second.expired());
}

TEST_F(ProgramsOfService, ThatAreGoneTakeNoCommands) {
    ASSERT_TRUE(eval("program p { }\n"));
    RTT::OperationCaller<bool()> start(host.provides("p")->getOperation("start"));
    ASSERT_TRUE(service->unloadProgram("p"));
    EXPECT_FALSE(start());
}

}  // namespace
