// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Programs and state machines from C++: loaded with exceptions, and as the first argument of their operations.
#include <rtt/RTT.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/scripting/ScriptingService.hpp>

#include <gtest/gtest.h>

#include <fstream>

using namespace RTT;
using namespace RTT::scripting;

namespace {

class Robot : public TaskContext {
public:
    Robot() : TaskContext("robot"), scripts(ScriptingService::Create(this)) {
        setActivity(new extras::SlaveActivity(0.01));
        addProperty("speed", speed);
    }
    double speed = 0;
    ScriptingService::shared_ptr scripts;
};

const char* const kProgram = "program drive { speed = 1.0; yield; speed = 2.0 }\n";
const char* const kMachine =
    "StateMachine Mode { initial state idle { transition select busy } state busy { } final state off { } }\n"
    "RootMachine Mode mode\n";

}  // namespace

TEST(ScriptObjects, ProgramsAndMachinesAreLoadedFromTexts) {
    Robot robot;
    EXPECT_TRUE(robot.scripts->loadPrograms(kProgram, "drive.ops", true));
    EXPECT_TRUE(robot.scripts->hasProgram("drive"));
    EXPECT_TRUE(robot.scripts->loadStateMachines(kMachine, "mode.osd", false));
    EXPECT_TRUE(robot.scripts->hasStateMachine("mode"));
    EXPECT_FALSE(robot.scripts->loadPrograms("program bad {", "bad.ops"));
    EXPECT_FALSE(robot.scripts->loadPrograms(kMachine, "wrong.ops", false)) << "these are no programs";
}

TEST(ScriptObjects, LoadingThrowsIfItIsToldTo) {
    Robot robot;
    EXPECT_FALSE(robot.scripts->loadPrograms("/nowhere/robot.ops", false));
    EXPECT_THROW(robot.scripts->loadPrograms("/nowhere/robot.ops", true), program_load_exception);
    EXPECT_THROW(robot.scripts->loadStateMachines("/nowhere/robot.osd", true), file_parse_exception);
    try {
        robot.scripts->loadStateMachines("StateMachine Mode { initial", "broken.osd", true);
        FAIL() << "nothing was thrown";
    } catch (const program_load_exception& e) {
        EXPECT_NE(std::string::npos, std::string(e.what()).find("broken.osd:1:")) << e.what();
    }
    EXPECT_THROW(robot.scripts->unloadProgram("none", true), program_unload_exception);
    EXPECT_THROW(robot.scripts->unloadStateMachine("none", true), program_unload_exception);
    EXPECT_FALSE(robot.scripts->unloadProgram("none", false));
}

TEST(ScriptObjects, AFileIsLoadedWithOrWithoutExceptions) {
    Robot robot;
    const std::string file = testing::TempDir() + "script_objects.ops";
    std::ofstream(file) << kProgram;
    EXPECT_TRUE(robot.scripts->loadPrograms(file, true));
    EXPECT_TRUE(robot.scripts->unloadProgram("drive", true));
    EXPECT_TRUE(robot.scripts->loadPrograms(file, false));
}

TEST(ScriptObjects, ResetTakesAProgramBackToItsFirstStatement) {
    Robot robot;
    ASSERT_TRUE(robot.scripts->loadProgramText(kProgram));
    const ProgramInterfacePtr program = robot.scripts->getProgram("drive");
    ASSERT_TRUE(program->start());
    robot.update();
    EXPECT_EQ(1.0, robot.speed);
    EXPECT_TRUE(program->reset());
    EXPECT_TRUE(program->isStopped());
    robot.speed = 0;
    ASSERT_TRUE(program->start());
    robot.update();
    EXPECT_EQ(1.0, robot.speed);
    robot.update();
    EXPECT_EQ(2.0, robot.speed);
}

TEST(ScriptObjects, OperationsOfAProgramTakeItAsFirstArgumentInCpp) {
    Robot robot;
    ASSERT_TRUE(robot.scripts->loadProgramText(kProgram));
    const ProgramInterfacePtr program = robot.scripts->getProgram("drive");
    OperationCaller<bool(ProgramInterfacePtr)> start = robot.provides("drive")->getOperation("start");
    OperationCaller<bool(ProgramInterface*)> running = robot.provides("drive")->getOperation("isRunning");
    ASSERT_TRUE(start.ready() && running.ready());
    EXPECT_TRUE(start(program));
    EXPECT_TRUE(running(program.get()));
    OperationCaller<bool()> stop = robot.provides("drive")->getOperation("stop");
    EXPECT_TRUE(stop());
    EXPECT_FALSE(running(program.get()));
}

TEST(ScriptObjects, TheCurrentStateIsAnObject) {
    Robot robot;
    ASSERT_TRUE(robot.scripts->loadStateMachineText(kMachine));
    const StateMachinePtr machine = robot.scripts->getStateMachine("mode");
    EXPECT_EQ(nullptr, machine->currentState());
    ASSERT_TRUE(machine->activate());
    StateInterface* const state = machine->currentState();
    ASSERT_NE(nullptr, state);
    EXPECT_EQ("idle", state->getName());
    EXPECT_EQ(machine->getInitialState(), state);
    EXPECT_EQ("off", machine->getFinalState()->getName());
    ASSERT_TRUE(machine->requestState("busy"));
    robot.update();
    EXPECT_EQ(machine->getState("busy"), machine->currentState());
    EXPECT_EQ(nullptr, machine->getState("none"));
}

TEST(ScriptObjects, OperationsOfAMachineTakeItAsFirstArgumentInCpp) {
    Robot robot;
    ASSERT_TRUE(robot.scripts->loadStateMachineText(kMachine));
    const StateMachinePtr machine = robot.scripts->getStateMachine("mode");
    Service& service = *robot.provides("mode");
    OperationCaller<bool(StateMachinePtr)> activate = service.getOperation("activate");
    OperationCaller<bool(StateMachine*, const std::string&)> request(service.getOperation("requestState"),
                                                                     robot.engine());
    OperationCaller<bool(StateMachinePtr, const std::string&)> in = service.getOperation("inState");
    OperationCaller<std::string(StateMachinePtr)> state = service.getOperation("getState");
    ASSERT_TRUE(activate.ready() && request.ready() && in.ready() && state.ready());
    EXPECT_TRUE(activate(machine));
    EXPECT_TRUE(request(machine.get(), "busy"));
    robot.update();
    EXPECT_TRUE(in(machine, "busy"));
    EXPECT_EQ("busy", state(machine));
    EXPECT_THROW(activate(nullptr), std::runtime_error);
    OperationCaller<bool()> active = service.getOperation("isActive");
    EXPECT_TRUE(active()) << "without the argument it is this machine";
    SendHandle<bool(StateMachinePtr)> handle =
        OperationCaller<bool(StateMachinePtr)>(service.getOperation("deactivate"), robot.engine()).send(machine);
    bool done = false;
    EXPECT_EQ(SendSuccess, handle.collect(done));
    EXPECT_TRUE(done);
}
