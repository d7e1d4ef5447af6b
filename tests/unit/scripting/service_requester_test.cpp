// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The service as others find it: by name, through operations and through the requester.
#include "service_host.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/scripting/Scripting.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

namespace {

using RTT::OperationCaller;
using service_test::Host;
using service_test::ServiceTest;
using testing::ElementsAre;

class RequesterOfService : public ServiceTest {};

TEST_F(RequesterOfService, TheServiceIsLoadedWhenItIsAskedFor) {
    Host fresh("fresh");
    EXPECT_FALSE(fresh.provides()->hasService("scripting"));
    const auto scripting = fresh.getProvider<RTT::Scripting>("scripting");
    ASSERT_TRUE(scripting);
    EXPECT_TRUE(fresh.provides()->hasService("scripting"));
    EXPECT_TRUE(scripting->ready()) << scripting->missingOperations();
    EXPECT_TRUE(scripting->eval("count = 3"));
    EXPECT_EQ(3, fresh.count);
    EXPECT_TRUE(fresh.loadService("scripting"));
}

TEST_F(RequesterOfService, CreateGivesTheServiceOfAComponent) {
    EXPECT_EQ(service, RTT::scripting::ScriptingService::Create(&host));
    Host fresh("fresh");
    const auto made = RTT::scripting::ScriptingService::Create(&fresh);
    ASSERT_TRUE(made);
    EXPECT_EQ(made, fresh.provides()->getService("scripting"));
}

TEST_F(RequesterOfService, CommandsProgramsAndStateMachines) {
    const auto scripting = host.getProvider<RTT::Scripting>("scripting");
    ASSERT_TRUE(scripting);
    EXPECT_TRUE(scripting->loadProgramText("program p { count = count + 1\n yield\n count = count + 10 }"));
    EXPECT_TRUE(scripting->startProgram("p"));
    host.step();
    EXPECT_EQ(1, host.count);
    EXPECT_TRUE(scripting->isProgramRunning("p"));
    EXPECT_EQ("running", scripting->getProgramStatusStr("p"));
    EXPECT_EQ(RTT::scripting::ProgramInterface::Status::running, scripting->getProgramStatus("p"));
    EXPECT_EQ(RTT::scripting::ProgramInterface::Status::unknown, scripting->getProgramStatus("q"));
    EXPECT_EQ(3, scripting->getProgramLine("p"));
    EXPECT_THAT(scripting->getProgramList(), ElementsAre("p"));
    EXPECT_TRUE(
        scripting->loadStateMachineText("StateMachine T { initial state a { } final state b { } }\nRootMachine T m"));
    EXPECT_TRUE(scripting->activateStateMachine("m"));
    EXPECT_TRUE(scripting->inStateMachineState("m", "a"));
    EXPECT_EQ("a", scripting->getStateMachineState("m"));
    EXPECT_EQ(RTT::scripting::StateMachine::Status::active, scripting->getStateMachineStatus("m"));
    EXPECT_THAT(scripting->getStateMachineList(), ElementsAre("m"));
    EXPECT_TRUE(scripting->unloadStateMachine("m"));
    EXPECT_TRUE(scripting->unloadProgram("p"));
}

TEST_F(RequesterOfService, OperationsAreCalledByScripts) {
    EXPECT_TRUE(
        eval("program p { }\n"
             "if (scripting.hasProgram(\"p\") && scripting.getProgramStatusStr(\"p\") == \"stopped\") then count = 1\n"
             "if (scripting.startProgram(\"p\")) then count = count + 10\n"));
    EXPECT_EQ(11, host.count);
}

TEST_F(RequesterOfService, FilesAreLoaded) {
    const oroforge::test::TempDir directory;
    const auto scripting = host.getProvider<RTT::Scripting>("scripting");
    ASSERT_TRUE(scripting);
    EXPECT_TRUE(scripting->loadPrograms(directory.write("p.ops", "void f() { }\nprogram p { f() }\n")));
    EXPECT_TRUE(scripting->hasProgram("p"));
    EXPECT_TRUE(scripting->loadStateMachines(
        directory.write("m.osd", "StateMachine T { initial state a { } final state b { } }\nRootMachine T m\n")));
    EXPECT_TRUE(scripting->hasStateMachine("m"));
    EXPECT_TRUE(scripting->runScript(directory.write("s.ops", "m.activate()\np.start()\n")));
    EXPECT_TRUE(scripting->isStateMachineActive("m"));
}

TEST_F(RequesterOfService, EveryOperationIsDocumented) {
    for (const std::string& name : service->getOperationNames()) {
        EXPECT_NE("", service->getDescription(name)) << name;
        for (const auto& argument : service->getArgumentList(name)) {
            EXPECT_NE("", argument.name) << name;
            EXPECT_NE("", argument.description) << name;
        }
    }
}

TEST_F(RequesterOfService, PropertiesAreThere) {
    EXPECT_EQ("true", service->getProperty("ZeroPeriodWarning")->getDataSource()->toString());
    EXPECT_EQ("0", service->getProperty("StepBudget")->getDataSource()->toString());
}

}  // namespace
