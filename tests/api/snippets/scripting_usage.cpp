// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Scripts from C++: the requester, the service, programs and state machines.
#include <rtt/RTT.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/scripting/Scripting.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <rtt/scripting/StateMachine.hpp>
#include <rtt/scripting/rtt-scripting-fwd.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using namespace RTT;

class Robot : public TaskContext {
public:
    Robot() : TaskContext("robot") {
        setActivity(new extras::SlaveActivity(0.01));
        addProperty("speed", speed);
    }
    double speed = 0;
};

const char* const kMachine =
    "StateMachine Mode { initial state idle { transition select busy } state busy { } final state off { } }\n"
    "RootMachine Mode mode\n";

TEST(ScriptingUsage, ARequesterRunsScripts) {
    Robot robot;
    boost::shared_ptr<Scripting> scripting = robot.getProvider<Scripting>("scripting");
    ASSERT_TRUE(scripting && scripting->ready());
    EXPECT_TRUE(scripting->eval("speed = 0.5"));
    EXPECT_EQ(0.5, robot.speed);
    EXPECT_FALSE(scripting->runScript("/nowhere/robot.ops"));
    EXPECT_FALSE(scripting->loadPrograms("/nowhere/robot.ops"));
    EXPECT_FALSE(scripting->loadStateMachines("/nowhere/robot.osd"));
}

TEST(ScriptingUsage, TheServiceGivesPrograms) {
    Robot robot;
    ASSERT_TRUE(robot.loadService("scripting"));
    scripting::ScriptingService::shared_ptr service =
        boost::dynamic_pointer_cast<scripting::ScriptingService>(robot.provides("scripting"));
    ASSERT_TRUE(service);
    ASSERT_TRUE(service->loadProgramText("program drive { speed = 1.0 }"));
    const std::vector<std::string> programs = service->getProgramList();
    EXPECT_EQ(1, std::count(programs.begin(), programs.end(), "drive"));
    scripting::ProgramInterfacePtr program = service->getProgram("drive");
    ASSERT_TRUE(program && program->start());
    EXPECT_TRUE(service->isProgramRunning("drive"));
    EXPECT_EQ(scripting::ProgramInterface::Status::running, program->getStatus());
    robot.update();
    EXPECT_TRUE(program->isStopped());
    EXPECT_EQ(1.0, robot.speed);
    base::ExecutableInterface* executable = program.get();
    EXPECT_EQ(robot.engine(), executable->getEngine());
}

TEST(ScriptingUsage, TheServiceGivesStateMachines) {
    Robot robot;
    const auto service = scripting::ScriptingService::Create(&robot);
    ASSERT_TRUE(service && service->loadStateMachineText(kMachine));
    scripting::StateMachinePtr machine = service->getStateMachine("mode");
    ASSERT_TRUE(machine);
    EXPECT_TRUE(service->activateStateMachine("mode"));
    EXPECT_EQ("idle", machine->getCurrentStateName());
    EXPECT_TRUE(machine->requestState("busy"));
    robot.update();
    EXPECT_TRUE(machine->inState("busy"));
    EXPECT_TRUE(service->startStateMachine("mode"));
    EXPECT_EQ(std::vector<std::string>{"mode"}, service->getStateMachineList());
    EXPECT_TRUE(service->deactivateStateMachine("mode"));
    EXPECT_FALSE(machine->isActive());
}

TEST(ScriptingUsage, OldNamesOfTheNamespaceWork) {
    Robot robot;
    Orocos::scripting::ScriptingService service(&robot);
    EXPECT_TRUE(service.eval("speed = 2.0"));
    EXPECT_EQ(2.0, robot.speed);
}

}  // namespace
