// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The state machines that the scripting service keeps.
#include "service_host.hpp"

#include <gmock/gmock.h>

namespace {

using RTT::scripting::StateMachine;
using service_test::Host;
using service_test::ServiceTest;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

const char* const kLamp = R"(StateMachine Lamp {
  initial state off {
    entry { note("off") }
    transition if count > 0 then select on
  }
  state on {
    entry { note("on") }
    run { count = count + 1 }
    exit { note("leaves on") }
    transition select gone
  }
  final state gone {
    entry { note("gone") }
  }
}
)";

class MachinesOfService : public ServiceTest {
protected:
    bool loadLamp() { return eval(std::string(kLamp) + "RootMachine Lamp lamp\n"); }
    /** Steps in each of which the machine counts, or in none of which. */
    void count(int each) {
        host.step();
        const int before = host.count;
        host.step(3);
        EXPECT_EQ(host.count, before + 3 * each);
    }
};

TEST_F(MachinesOfService, AreExecutedByTheEngine) {
    ASSERT_TRUE(loadLamp());
    EXPECT_THAT(service->getStateMachineList(), ElementsAre("lamp"));
    EXPECT_TRUE(service->hasStateMachine("lamp"));
    EXPECT_TRUE(host.provides()->hasService("lamp"));
    host.step();
    EXPECT_EQ("inactive", service->getStateMachineStatusStr("lamp"));
    EXPECT_EQ("", service->getStateMachineState("lamp"));
    EXPECT_TRUE(service->activateStateMachine("lamp"));
    EXPECT_TRUE(service->isStateMachineActive("lamp"));
    EXPECT_EQ("off", service->getStateMachineState("lamp"));
    EXPECT_TRUE(service->inStateMachineState("lamp", "off"));
    EXPECT_FALSE(service->inStateMachineState("lamp", "on"));
    EXPECT_TRUE(service->startStateMachine("lamp"));
    EXPECT_TRUE(service->isStateMachineRunning("lamp"));
    host.step(2);
    EXPECT_EQ("off", service->getStateMachineState("lamp"));
    host.count = 1;
    host.step();
    EXPECT_THAT(host.notes, ElementsAre("off", "on"));
    EXPECT_TRUE(service->pauseStateMachine("lamp"));
    host.step();
    EXPECT_TRUE(service->isStateMachinePaused("lamp"));
    EXPECT_EQ(StateMachine::Status::paused, service->getStateMachineStatus("lamp"));
    EXPECT_TRUE(service->stopStateMachine("lamp"));
    host.step(3);
    EXPECT_EQ("gone", service->getStateMachineState("lamp"));
    EXPECT_TRUE(service->resetStateMachine("lamp"));
    host.step();
    EXPECT_EQ("off", service->getStateMachineState("lamp"));
    EXPECT_TRUE(service->requestStateMachineState("lamp", "on"));
    EXPECT_TRUE(service->deactivateStateMachine("lamp"));
    EXPECT_FALSE(service->inStateMachineError("lamp"));
    EXPECT_THAT(service->getStateMachineText("lamp"), StartsWith("StateMachine Lamp {"));
}

TEST_F(MachinesOfService, GiveTheTextOfTheirTypeWithTheCommentBeforeIt) {
    ASSERT_TRUE(eval(std::string("count = 1\n\n// a lamp\n") + kLamp + "RootMachine Lamp lamp\n"));
    EXPECT_THAT(service->getStateMachineText("lamp"), StartsWith("// a lamp\nStateMachine Lamp {"));
    EXPECT_EQ(3, service->getStateMachine("lamp")->getFirstLine());
}

TEST_F(MachinesOfService, ObeyEveryCommandAfterTheyHadNothingToDoForLong) {
    ASSERT_TRUE(
        eval("StateMachine M {\n"
             "  initial state A { run { count = count + 1 } transitions { if count > 1000 then select Z } }\n"
             "  final state Z { entry { yield\n count = 0 } }\n"
             "}\nRootMachine M m\n"));
    for (int round = 0; round != 3; ++round) {
        host.step(3);
        EXPECT_TRUE(service->activateStateMachine("m"));
        EXPECT_TRUE(service->startStateMachine("m"));
        count(1);
        EXPECT_TRUE(service->pauseStateMachine("m"));
        count(0);
        EXPECT_TRUE(service->getStateMachine("m")->step());
        host.step(3);
        EXPECT_TRUE(service->isStateMachinePaused("m"));
        EXPECT_TRUE(service->startStateMachine("m"));
        count(1);
        EXPECT_TRUE(service->stopStateMachine("m"));
        host.step(4);
        EXPECT_EQ("stopped", service->getStateMachineStatusStr("m"));
        EXPECT_EQ(0, host.count);
        EXPECT_TRUE(service->pauseStateMachine("m"));
        host.step(3);
        EXPECT_TRUE(service->isStateMachinePaused("m"));
        EXPECT_TRUE(service->stopStateMachine("m"));
        host.step(4);
        EXPECT_TRUE(service->resetStateMachine("m"));
        host.step(3);
        EXPECT_TRUE(service->inStateMachineState("m", "A"));
        EXPECT_TRUE(service->deactivateStateMachine("m"));
    }
    EXPECT_TRUE(service->unloadStateMachine("m"));
}

TEST_F(MachinesOfService, ThatDoNotExistAreUnknown) {
    EXPECT_THAT(service->getStateMachineList(), IsEmpty());
    EXPECT_FALSE(service->hasStateMachine("m"));
    EXPECT_FALSE(service->activateStateMachine("m"));
    EXPECT_FALSE(service->deactivateStateMachine("m"));
    EXPECT_FALSE(service->startStateMachine("m"));
    EXPECT_FALSE(service->pauseStateMachine("m"));
    EXPECT_FALSE(service->stopStateMachine("m"));
    EXPECT_FALSE(service->resetStateMachine("m"));
    EXPECT_FALSE(service->requestStateMachineState("m", "s"));
    EXPECT_FALSE(service->isStateMachineActive("m"));
    EXPECT_FALSE(service->isStateMachineRunning("m"));
    EXPECT_FALSE(service->isStateMachinePaused("m"));
    EXPECT_FALSE(service->inStateMachineError("m"));
    EXPECT_FALSE(service->inStateMachineState("m", "s"));
    EXPECT_EQ("", service->getStateMachineState("m"));
    EXPECT_EQ("unloaded", service->getStateMachineStatusStr("m"));
    EXPECT_EQ(StateMachine::Status::unloaded, service->getStateMachineStatus("m"));
    EXPECT_EQ(-1, service->getStateMachineLine("m"));
    EXPECT_EQ("", service->getStateMachineText("m"));
}

TEST_F(MachinesOfService, ATypeMayComeFromAnEarlierScript) {
    ASSERT_TRUE(eval(kLamp));
    EXPECT_TRUE(service->loadStateMachineText("RootMachine Lamp one\nRootMachine Lamp two\n"));
    EXPECT_THAT(service->getStateMachineList(), ElementsAre("one", "two"));
}

TEST_F(MachinesOfService, ATypeIsDefinedOnceInAScript) {
    EXPECT_FALSE(
        eval("StateMachine T { initial state a { } final state b { } }\n"
             "StateMachine T { initial state a { } final state b { } }\n"));
    EXPECT_EQ(
        "eval():2:14: error: [OPS301] state machine type 'T' is defined twice in this script\n"
        "StateMachine T { initial state a { } final state b { } }\n"
        "             ^\n"
        "eval():1:14: note: first defined here\n"
        "StateMachine T { initial state a { } final state b { } }\n"
        "             ^\n",
        logged());
}

TEST_F(MachinesOfService, HaveNamesOfTheirOwn) {
    ASSERT_TRUE(loadLamp());
    EXPECT_FALSE(eval("RootMachine Lamp lamp\n"));
    EXPECT_EQ(
        "eval():1:18: error: [OPS303] state machine 'lamp' cannot be loaded: component 'host' has a state "
        "machine of that name already\n"
        "RootMachine Lamp lamp\n"
        "                 ^\n",
        logged());
    EXPECT_FALSE(service->loadStateMachine(service->getStateMachine("lamp")));
    EXPECT_EQ("ERROR: state machine 'lamp' cannot be loaded: it is loaded already\n", logged());
    EXPECT_TRUE(service->hasStateMachine("lamp"));
}

TEST_F(MachinesOfService, ArePartOfOthers) {
    ASSERT_TRUE(eval(std::string(kLamp) + "StateMachine House {\n"
                                          "  SubMachine Lamp lamp\n"
                                          "  initial state idle { entry { lamp.activate() } }\n"
                                          "  final state end { }\n"
                                          "}\n"
                                          "RootMachine House house\n"));
    EXPECT_THAT(service->getStateMachineList(), ElementsAre("house", "house.lamp"));
    ASSERT_TRUE(service->activateStateMachine("house"));
    EXPECT_THAT(host.notes, ElementsAre("off"));
    EXPECT_EQ("off", service->getStateMachineState("house.lamp"));
    EXPECT_FALSE(service->unloadStateMachine("house.lamp"));
    EXPECT_EQ("ERROR: state machine 'house.lamp' cannot be unloaded: it is part of 'house'\n", logged());
    EXPECT_TRUE(service->unloadStateMachine("house"));
    EXPECT_THAT(service->getStateMachineList(), IsEmpty());
    EXPECT_FALSE(host.provides()->hasService("house"));
    EXPECT_THAT(host.notes, ElementsAre("off", "gone"));
}

TEST_F(MachinesOfService, AreStoppedBeforeTheyAreUnloaded) {
    ASSERT_TRUE(loadLamp());
    ASSERT_TRUE(service->activateStateMachine("lamp"));
    ASSERT_TRUE(service->startStateMachine("lamp"));
    host.step();
    EXPECT_TRUE(service->unloadStateMachine("lamp"));
    EXPECT_THAT(host.notes, ElementsAre("off", "gone"));
    EXPECT_FALSE(service->hasStateMachine("lamp"));
    EXPECT_FALSE(host.provides()->hasService("lamp"));
    EXPECT_TRUE(loadLamp());
}

TEST_F(MachinesOfService, ThatAreNotThereCannotBeUnloaded) {
    ASSERT_TRUE(loadLamp());
    EXPECT_FALSE(service->unloadStateMachine("lamb"));
    EXPECT_EQ("ERROR: state machine 'lamb' cannot be unloaded: there is none of that name; did you mean 'lamp'?\n",
              logged());
}

TEST_F(MachinesOfService, ThatDoNotReachTheirFinalStateStay) {
    ASSERT_TRUE(
        eval("StateMachine T {\n"
             "  initial state s { exit { while (true) { yield } } }\n"
             "  final state e { }\n"
             "}\n"
             "RootMachine T stuck\n"));
    ASSERT_TRUE(service->activateStateMachine("stuck"));
    host.step();
    EXPECT_FALSE(service->unloadStateMachine("stuck"));
    EXPECT_EQ("CRITICAL: state machine 'stuck' cannot be unloaded: it does not leave state 's', line 2\n", logged());
    EXPECT_TRUE(service->hasStateMachine("stuck"));
    EXPECT_TRUE(service->getStateMachine("stuck")->isLoaded());
}

TEST_F(MachinesOfService, AComponentInFatalErrorTakesNone) {
    ASSERT_TRUE(eval(kLamp));
    host.breakDown();
    EXPECT_FALSE(eval("RootMachine Lamp lamp\n"));
    EXPECT_EQ("ERROR: state machine 'lamp' cannot be loaded: the engine of component 'host' does not take it\n",
              logged());
    EXPECT_FALSE(host.provides()->hasService("lamp"));
    EXPECT_FALSE(service->hasStateMachine("lamp"));
}

TEST_F(MachinesOfService, AComponentMayGoWhileTheyRun) {
    Host* const gone = new Host("gone");
    const auto scripting = gone->getProvider<RTT::scripting::ScriptingService>("scripting");
    ASSERT_TRUE(scripting->eval(std::string(kLamp) + "RootMachine Lamp lamp\nlamp.activate()\nlamp.start()\n"));
    gone->step();
    const auto machine = scripting->getStateMachine("lamp");
    delete gone;
    EXPECT_FALSE(machine->isLoaded());
}

TEST_F(MachinesOfService, GoAwayWithTheirService) {
    ASSERT_TRUE(loadLamp());
    const auto machine = service->getStateMachine("lamp");
    service->clear();
    EXPECT_FALSE(machine->isLoaded());
    EXPECT_FALSE(host.provides()->hasService("lamp"));
    EXPECT_FALSE(service->loadStateMachine(nullptr));
}

TEST_F(MachinesOfService, GoWhenTheirServiceIsTakenFromTheComponent) {
    ASSERT_TRUE(loadLamp());
    ASSERT_TRUE(eval("program p { yield }\np.start()\nlamp.activate()\n"));
    const auto machine = service->getStateMachine("lamp");
    const auto program = service->getProgram("p");
    service.reset();
    host.provides()->removeService("scripting");
    EXPECT_FALSE(machine->isLoaded());
    EXPECT_FALSE(program->isLoaded());
    EXPECT_FALSE(host.provides()->hasService("lamp"));
    EXPECT_FALSE(host.provides()->hasService("p"));
    EXPECT_THAT(host.notes, ElementsAre("off", "gone")) << "stopped, since the component is alive";
    EXPECT_EQ("", logged());
    EXPECT_TRUE(RTT::scripting::ScriptingService::Create(&host)->eval("program p { }\n"));
}

TEST_F(MachinesOfService, ThatWereUnloadedByTheirComponentAreFreed) {
    host.addOperation("unload", [this] { return service->unloadStateMachine("lamp"); });
    boost::weak_ptr<StateMachine> machine, part;
    for (int round = 0; round != 3; ++round) {
        ASSERT_TRUE(eval(std::string(kLamp) +
                         "StateMachine House { SubMachine Lamp part\n initial state a { } final state b { } }\n"
                         "RootMachine House lamp\nprogram p { unload() }\np.start()\n"));
        EXPECT_TRUE(machine.expired() && part.expired()) << round;
        machine = service->getStateMachine("lamp");
        part = service->getStateMachine("lamp.part");
        host.step();
        EXPECT_FALSE(service->hasStateMachine("lamp"));
        ASSERT_TRUE(service->unloadProgram("p"));
    }
    EXPECT_TRUE(machine.expired() && part.expired());
}

TEST_F(MachinesOfService, ThatWereUnloadedWhileTheyAreExecutedStayUntilThen) {
    // As a message that comes while a program of the machine waits: another thread unloads it by force.
    host.addOperation("leave", [this] { host.provides()->removeService("scripting"); });
    ASSERT_TRUE(
        eval("StateMachine T { initial state a { run { leave(); count = count + 1 } } final state b { } }\n"
             "RootMachine T m\nm.activate()\nm.requestState(\"a\")\n"));
    boost::weak_ptr<StateMachine> machine = service->getStateMachine("m");
    service.reset();
    host.step();
    EXPECT_EQ(1, host.count);
    EXPECT_TRUE(machine.expired());
    EXPECT_EQ("ERROR: state machine 'm' cannot be unloaded: one of its own programs asks for it\n", logged());
    host.step();
    EXPECT_EQ(1, host.count);
}

TEST_F(MachinesOfService, OfATextWithAnErrorAreNotLoaded) {
    EXPECT_FALSE(service->loadStateMachineText(std::string(kLamp) + "RootMachine Lamp one\nRootMachine Lmap two\n"));
    EXPECT_THAT(service->getStateMachineList(), IsEmpty());
    EXPECT_FALSE(host.provides()->hasService("one"));
    EXPECT_TRUE(service->loadStateMachineText(std::string(kLamp) + "RootMachine Lamp one\n"));
}

}  // namespace
