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
            count = 1 / 0
            note("after")
        }
    }
    final state Z { entry { note("z") } }
}
RootMachine T m
)");
    m->activate();
    m->start();
    EXPECT_EQ(station.step(), "before");
    EXPECT_TRUE(m->inError());
    EXPECT_EQ(m->getLineNumber(), 6);
    const std::string message = "eval():6:13: error: [OPS400] state machine 'm' failed in state 'A': division by zero";
    EXPECT_EQ(m->getError(), message);
    EXPECT_EQ(logged(), message + "\n            count = 1 / 0\n            ^\n");
    EXPECT_EQ(station.step(), "");
    EXPECT_FALSE(m->start());
    EXPECT_TRUE(m->stop());
    EXPECT_EQ(station.step(), "z");
    EXPECT_EQ(m->getError(), "");
}

TEST_F(MachineScriptFailure, FailureThatIsCaughtIsNone) {
    const StateMachinePtr m = load(R"(
        StateMachine T {
            initial state A { run { try count = 1 / 0 catch { note("caught") } } }
            final state Z { }
        }
        RootMachine T m
    )");
    m->activate();
    m->start();
    EXPECT_THAT(station.step(), testing::StartsWith("caught"));
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

TEST_F(MachineScriptFailure, ConditionsAndValuesAreDecidedAtOnceThoughAFunctionInThemYields) {
    const StateMachinePtr m = load(R"(
int slow(int n) { nothing; yield; return n }
StateMachine T {
    var int three = slow(3)
    initial state A {
        precondition slow(1) == 1
        transition if slow(count) == three then select Z
    }
    final state Z { }
}
RootMachine T m
)");
    EXPECT_TRUE(m->activate());
    m->start();
    station.step();
    EXPECT_EQ(m->getCurrentStateName(), "A");
    station.count = 3;
    station.step();
    EXPECT_EQ(m->getCurrentStateName(), "Z");
}

TEST_F(MachineScriptFailure, ConditionThatWaitsForEverIsAnError) {
    const StateMachinePtr m = load(R"(
bool slow() { while !go nothing; return true }
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
    EXPECT_THAT(m->getError(), testing::EndsWith("yielded 10000 times, but has to be decided at once"));
    station.go = true;
    EXPECT_TRUE(m->stop());
    station.step();
    EXPECT_TRUE(m->reset() && m->start());
    station.step();
    EXPECT_EQ(m->getCurrentStateName(), "Z") << "it is asked again";
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
    m->start();
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
    m->start();
    EXPECT_THAT(station.step(), testing::StartsWith("refused"));
    EXPECT_THAT(logged("ERROR"),
                testing::StartsWith("state machine 'm' cannot be unloaded: one of its own programs asks for it\n"));
    EXPECT_EQ(m->getStatus(), Status::running);
    EXPECT_TRUE(service->unloadStateMachine("m"));
}

}  // namespace
