// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// State machines of scripts in which something goes wrong.
#include "machine_station.hpp"

namespace {

using namespace machine_test;

class MachineScriptFailure : public MachineTest {};

TEST_F(MachineScriptFailure, FailureOfAProgramIsToldWithItsPlace) {
    const StateMachinePtr m = load(R"(
StateMachine T {
    initial state A {
        run {
            note("before")
            fail()
            note("after")
        }
    }
    final state Z { entry { note("z") } }
}
RootMachine T m
)");
    m->activate();
    EXPECT_EQ(station.step(), "before");
    EXPECT_TRUE(m->inError());
    EXPECT_EQ(m->getLineNumber(), 6);
    const std::string message =
        "eval():6:13: error: [OPS400] state machine 'm' failed in state 'A': the motor is stuck";
    EXPECT_EQ(m->getError(), message);
    EXPECT_EQ(logged(), message + "\n            fail()\n            ^\n");
    EXPECT_EQ(station.step(), "");
    EXPECT_FALSE(m->start());
    EXPECT_TRUE(m->stop());
    EXPECT_EQ(station.step(), "z");
    EXPECT_EQ(m->getError(), "");
}

TEST_F(MachineScriptFailure, FailureThatIsCaughtIsNone) {
    const StateMachinePtr m = load(R"(
        StateMachine T {
            initial state A { run { try fail() catch { note("caught") } } }
            final state Z { }
        }
        RootMachine T m
    )");
    m->activate();
    EXPECT_EQ(station.step(), "caught");
    EXPECT_FALSE(m->inError());
}

TEST_F(MachineScriptFailure, FailureOfAConditionIsToldWithItsPlace) {
    const StateMachinePtr m = load(R"(
StateMachine T {
    initial state A {
        transition if 1 / count == 1 then select Z
    }
    final state Z { }
}
RootMachine T m
)");
    m->activate();
    m->start();
    station.step();
    EXPECT_EQ(logged(),
              "eval():4:33: error: [OPS400] state machine 'm' failed in state 'A': division by zero\n"
              "        transition if 1 / count == 1 then select Z\n"
              "                                ^\n");
}

TEST_F(MachineScriptFailure, ConditionMustNotWait) {
    const StateMachinePtr m = load(R"(
bool slow() { yield; return true }
StateMachine T {
    initial state A {
        transition if slow() then select Z
    }
    final state Z { }
}
RootMachine T m
)");
    m->activate();
    m->start();
    station.step();
    EXPECT_TRUE(m->inError());
    EXPECT_THAT(m->getError(), testing::EndsWith("a condition has to be decided at once, but a function in it yields"));
}

TEST_F(MachineScriptFailure, LoopWithoutYieldIsAnErrorOfItsLineIfThereIsABudget) {
    const StateMachinePtr m = load(R"(
StateMachine T {
    initial state A { run {
        while true {
            count = count + 1
        }
    } }
    final state Z { }
}
RootMachine T m
)");
    RTT::Property<unsigned int> budget(service->getProperty("StepBudget"));
    ASSERT_TRUE(budget.ready());
    budget.set(1000);
    m->activate();
    station.step();
    EXPECT_TRUE(m->inError());
    EXPECT_EQ(m->getLineNumber(), 5);
    EXPECT_EQ(station.count, 1000);
}

TEST_F(MachineScriptFailure, IsNotActivatedIfAValueCannotBeComputed) {
    const StateMachinePtr m = load(R"(
StateMachine T {
    var int x = 1 / count
    initial state A { }
    final state Z { }
}
RootMachine T m
)");
    EXPECT_FALSE(m->activate());
    EXPECT_EQ(m->getStatus(), Status::inactive);
    EXPECT_EQ(logged(),
              "eval():3:5: error: [OPS400] state machine 'm' failed: division by zero\n"
              "    var int x = 1 / count\n"
              "    ^\n");
    station.count = 1;
    EXPECT_TRUE(m->activate());
}

TEST_F(MachineScriptFailure, UnloadingExecutesYieldsAndIsRefusedIfTheyDoNotEnd) {
    const StateMachinePtr m = load(R"(
        StateMachine T {
            initial state A { exit { while !go { yield } note("leaves") } }
            final state Z { entry { yield; note("z") } exit { yield; note("end") } }
        }
        RootMachine T m
    )");
    m->activate();
    EXPECT_FALSE(service->unloadStateMachine("m"));
    EXPECT_EQ(m->getStatus(), Status::stopping);
    station.go = true;
    EXPECT_TRUE(service->unloadStateMachine("m"));
    EXPECT_EQ(station.take(), "leaves z end");
}

TEST_F(MachineScriptFailure, UnloadingItselfIsRefused) {
    const StateMachinePtr m = load(R"(
        StateMachine T {
            initial state A { run { if scripting.unloadStateMachine("m") then note("gone") else note("refused") } }
            final state Z { }
        }
        RootMachine T m
    )");
    m->activate();
    EXPECT_EQ(station.step(), "refused");
    EXPECT_EQ(logged("ERROR"), "state machine 'm' cannot be unloaded: one of its own programs asks for it\n");
    EXPECT_EQ(m->getStatus(), Status::active);
    EXPECT_TRUE(service->unloadStateMachine("m"));
}

}  // namespace
