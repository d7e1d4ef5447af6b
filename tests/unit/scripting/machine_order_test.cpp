// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a cycle executes in which order, and what commands within it do.
#include "machine_fakes.hpp"

#include <gtest/gtest.h>

namespace {

using namespace machine_test;

TEST(MachineCycle, ExecutesTransitionsThenHandleThenRun) {
    FakeMachine machine;
    machine.add("A", machine.transition("first", {"B"}));
    machine.add("A", machine.transition("second", {"B"}));
    machine.add("", machine.transition("global", {"B"}));
    machine.core->activate();
    machine.core->automatic();
    EXPECT_EQ(machine.cycle(), "A.run first? second? global? A.handle A.run") << "the first one follows the entry";
    EXPECT_EQ(machine.cycle(), "first? second? global? A.handle A.run");
    EXPECT_EQ(machine.cycle(), "first? second? global? A.handle A.run");
}

TEST(MachineCycle, FirstTransitionThatMayBeTakenWins) {
    FakeMachine machine;
    machine.add("A", machine.transition("first", {"B"}));
    machine.add("A", machine.transition("second", {"Z"}));
    machine.add("", machine.transition("global", {"Z"}));
    machine.start();
    for (const char* name : {"first", "second", "global"}) machine.set(name, true);
    EXPECT_EQ(machine.cycle(), "first? A.exit B.entry");
    EXPECT_EQ(machine.stateName(), "B");
}

TEST(MachineCycle, TransitionsOfTheStateComeBeforeThoseOfTheMachine) {
    FakeMachine machine;
    machine.add("", machine.transition("global", {"Z"}));
    machine.add("A", machine.transition("own", {"B"}));
    machine.start();
    machine.set("global", true);
    machine.set("own", true);
    EXPECT_EQ(machine.cycle(), "own? A.exit B.entry");
}

TEST(MachineCycle, UnconditionalTransitionIsTakenAfterRun) {
    FakeMachine machine;
    machine.add("A", machine.transition("", {"B"}));
    machine.core->activate();
    machine.core->automatic();
    EXPECT_EQ(machine.cycle(), "A.run A.exit B.entry");
    EXPECT_EQ(machine.cycle(), "B.run B.handle B.run");
}

TEST(MachineCycle, TransitionIsProgramThenExitThenEntryAndRunComesInTheNextCycle) {
    FakeMachine machine;
    machine.add("A", machine.transition("go", {"B"}, "program"));
    machine.start();
    machine.set("go", true);
    EXPECT_EQ(machine.cycle(), "go? program A.exit B.entry");
    EXPECT_EQ(machine.cycle(), "B.run B.handle B.run");
    EXPECT_EQ(machine.cycle(), "B.handle B.run");
}

TEST(MachineCycle, EachProgramMaySpanCycles) {
    FakeMachine machine;
    machine.add("A", machine.transition("go", {"B"}, "program"));
    machine.start();
    for (const char* name : {"program", "A.exit", "B.entry", "B.handle", "B.run"}) machine.program(name).slices = 2;
    machine.set("go", true);
    EXPECT_EQ(machine.cycle(), "go? program/1");
    EXPECT_TRUE(machine.core->inTransition());
    EXPECT_EQ(machine.cycle(), "program/2 A.exit/1");
    EXPECT_EQ(machine.stateName(), "A");
    EXPECT_EQ(machine.cycle(), "A.exit/2 B.entry/1");
    EXPECT_EQ(machine.stateName(), "B");
    EXPECT_EQ(machine.cycle(), "B.entry/2");
    EXPECT_FALSE(machine.core->inTransition());
    EXPECT_EQ(machine.cycle(), "B.run/1");
    EXPECT_EQ(machine.cycle(), "B.run/2 B.handle/1");
    EXPECT_EQ(machine.cycle(), "B.handle/2 B.run/1");
}

TEST(MachineCycle, RunIsCompletedBeforeTransitionsAreLookedAt) {
    FakeMachine machine;
    machine.add("A", machine.transition("go", {"B"}));
    machine.program("A.run").slices = 3;
    machine.core->activate();
    machine.core->automatic();
    machine.set("go", true);
    EXPECT_EQ(machine.cycle(), "A.run/1");
    EXPECT_EQ(machine.cycle(), "A.run/2");
    EXPECT_EQ(machine.cycle(), "A.run/3 go? A.exit B.entry");
}

TEST(MachineCycle, StatesWithoutProgramsTakeACycleEach) {
    FakeMachine machine;
    for (auto& state : machine.model.states)
        for (RoutinePtr* program : {&state.entry, &state.run, &state.handle, &state.exit}) program->reset();
    machine.add("A", machine.transition("", {"B"}));
    machine.add("B", machine.transition("", {"Z"}));
    machine.core->activate();
    machine.core->automatic();
    machine.cycle();
    EXPECT_EQ(machine.stateName(), "B");
    machine.cycle();
    EXPECT_EQ(machine.stateName(), "Z");
}

TEST(MachineCycle, TransitionToSelfExecutesItsProgramAndGoesOnWithRun) {
    FakeMachine machine;
    machine.add("A", machine.transition("again", {}, "program"));
    machine.start();
    machine.set("again", true);
    EXPECT_EQ(machine.cycle(), "again? program A.run");
    EXPECT_EQ(machine.stateName(), "A");
    EXPECT_EQ(machine.cycle(), "again? program A.run");
}

TEST(MachineCycle, SelectingThePresentStateIsATransitionToSelf) {
    FakeMachine machine;
    machine.add("A", machine.transition("again", {"A"}, "program"));
    machine.state("A").preconditions.push_back(machine.guard("fit", true));
    machine.start();
    machine.set("again", true);
    machine.set("fit", false);
    EXPECT_EQ(machine.cycle(), "again? program A.run") << "no exit, no entry, so no precondition";
}

TEST(MachineCycle, TransitionToSelfWithoutProgramHandles) {
    FakeMachine machine;
    machine.add("A", machine.transition("again", {}));
    machine.start();
    machine.set("again", true);
    EXPECT_EQ(machine.cycle(), "again? A.handle A.run");
}

TEST(MachineCycle, PreconditionsDecideBetweenAlternatives) {
    FakeMachine machine;
    machine.add("A", machine.transition("go", {"B", "Z"}));
    machine.state("B").preconditions.push_back(machine.guard("b1", true));
    machine.state("B").preconditions.push_back(machine.guard("b2"));
    machine.state("Z").preconditions.push_back(machine.guard("z"));
    machine.start();
    machine.set("go", true);
    EXPECT_EQ(machine.cycle(), "go? b1? b2? z? A.handle A.run") << "skipped, since no alternative may be entered";
    machine.set("z", true);
    EXPECT_EQ(machine.cycle(), "go? b1? b2? z? A.exit Z.entry");
}

TEST(MachineCycle, SkippedTransitionLetsTheNextOneTry) {
    FakeMachine machine;
    machine.add("A", machine.transition("first", {"B"}));
    machine.add("A", machine.transition("second", {"Z"}));
    machine.state("B").preconditions.push_back(machine.guard("fit"));
    machine.start();
    machine.set("first", true);
    machine.set("second", true);
    EXPECT_EQ(machine.cycle(), "first? fit? second? A.exit Z.entry");
}

TEST(MachineCycle, ElseIsTakenWhenTheConditionIsFalse) {
    FakeMachine machine;
    MachineTransition transition = machine.transition("go", {"B"}, "yes");
    transition.otherwise = std::make_unique<MachineSelection>();
    transition.otherwise->states.push_back(&machine.state("Z"));
    transition.otherwise->program = machine.routine("no");
    machine.add("A", std::move(transition));
    machine.core->activate();
    machine.core->automatic();
    EXPECT_EQ(machine.cycle(), "A.run go? no A.exit Z.entry");
}

TEST(MachineCycle, ElseOfAPortIsTakenOnlyWithNewData) {
    FakeMachine machine;
    MachineTransition transition = machine.transition("go", {"B"});
    transition.event = machine.guard("data");
    transition.otherwise = std::make_unique<MachineSelection>();
    transition.otherwise->states.push_back(&machine.state("Z"));
    machine.add("A", std::move(transition));
    machine.start();
    EXPECT_EQ(machine.cycle(), "data? A.handle A.run");
    machine.set("data", true);
    EXPECT_EQ(machine.cycle(), "data? go? A.exit Z.entry");
}

TEST(MachineCycle, ConditionsOfACycleShareARoundAndThoseOfTheNextDoNot) {
    FakeMachine machine;
    machine.add("A", machine.transition("one", {"B"}));
    machine.add("", machine.transition("two", {"B"}));
    machine.start();
    machine.cycle();
    const auto& one = machine.guards["one"]->rounds;
    const auto& two = machine.guards["two"]->rounds;
    ASSERT_EQ(one.size(), 2u);
    EXPECT_EQ(one, two);
    EXPECT_NE(one[0], one[1]);
}

TEST(MachineCycle, VariablesOfAStateAreAssignedWhenItIsEntered) {
    FakeMachine machine;
    machine.state("B").locals = machine.routine("B.locals");
    machine.add("A", machine.transition("", {"B"}));
    machine.core->activate();
    machine.core->automatic();
    EXPECT_EQ(machine.cycle(), "A.run A.exit B.locals B.entry");
}

TEST(MachineFailure, OfEachProgramIsAnErrorThatDropsTheRest) {
    for (const char* name : {"A.run", "A.handle", "A.exit", "program", "B.entry"}) {
        FakeMachine machine;
        machine.add("A", machine.transition("go", {"B"}, "program"));
        machine.start();
        machine.set("go", std::string(name) != "A.run" && std::string(name) != "A.handle");
        machine.program(name).fails = true;
        machine.cycle();
        EXPECT_EQ(machine.core->status(), Status::error) << name;
        EXPECT_EQ(machine.failures, std::vector<std::string>{"101: " + std::string(name) + " failed"});
        EXPECT_EQ(machine.core->line(), 101u);
        EXPECT_FALSE(machine.core->inTransition());
        EXPECT_EQ(machine.cycle(), "") << name;
    }
}

TEST(MachineFailure, OfAConditionIsAnError) {
    FakeMachine machine;
    machine.add("A", machine.transition("go", {"B"}));
    machine.start();
    machine.guards["go"]->truth = Guard::Truth::Failed;
    EXPECT_EQ(machine.cycle(), "go?");
    EXPECT_EQ(machine.core->status(), Status::error);
    EXPECT_EQ(machine.failures, std::vector<std::string>{"7: go cannot be told"});
}

TEST(MachineFailure, OfAPreconditionIsAnError) {
    FakeMachine machine;
    machine.add("A", machine.transition("", {"B"}));
    machine.state("B").preconditions.push_back(machine.guard("fit"));
    machine.guards["fit"]->truth = Guard::Truth::Failed;
    machine.core->activate();
    machine.core->automatic();
    EXPECT_EQ(machine.cycle(), "A.run fit?");
    EXPECT_EQ(machine.core->status(), Status::error);
}

TEST(MachineWithin, RunMayRequestAState) {
    FakeMachine machine;
    machine.add("A", machine.transition("go", {"B"}));
    machine.start();
    bool accepted = false;
    machine.program("A.run").does = [&] { accepted = machine.core->requestState(machine.state("Z")); };
    EXPECT_EQ(machine.cycle(), "go? A.handle A.run A.exit Z.entry");
    EXPECT_TRUE(accepted);
}

TEST(MachineWithin, RunThatRequestsItsOwnStateIsExecutedOncePerCycle) {
    FakeMachine machine;
    machine.start();
    machine.program("A.run").does = [&] { machine.core->requestState(machine.state("A")); };
    EXPECT_EQ(machine.cycle(), "A.handle A.run A.handle");
    EXPECT_EQ(machine.cycle(), "A.handle A.run A.handle");
}

TEST(MachineWithin, OtherProgramsMayNotRequestStates) {
    for (const char* name : {"A.handle", "A.exit", "program", "B.entry"}) {
        FakeMachine machine;
        machine.add("A", machine.transition("go", {"B"}, "program"));
        machine.start();
        bool accepted = true;
        machine.program(name).does = [&] { accepted = machine.core->requestState(machine.state("Z")); };
        machine.set("go", std::string(name) != "A.handle");
        machine.cycle();
        EXPECT_FALSE(accepted) << name;
        EXPECT_EQ(machine.stateName(), std::string(name) == "A.handle" ? "A" : "B");
    }
}

TEST(MachineWithin, ConditionMayNotRequestAState) {
    FakeMachine machine;
    machine.add("A", machine.transition("go", {"B"}));
    machine.start();
    bool accepted = true;
    machine.guards["go"]->does = [&] { accepted = machine.core->requestState(machine.state("Z")); };
    machine.cycle();
    EXPECT_FALSE(accepted);
}

TEST(MachineWithin, DeactivateWaitsForTheEndOfTheSlice) {
    FakeMachine machine;
    machine.program("A.run").slices = 3;
    machine.start();
    machine.program("A.run").does = [&] {
        EXPECT_TRUE(machine.core->deactivate());
        EXPECT_EQ(machine.core->status(), Status::deactivating);
    };
    machine.core->automatic();
    EXPECT_EQ(machine.cycle(), "A.run/1 A.exit");
    EXPECT_EQ(machine.core->status(), Status::inactive);
}

TEST(MachineWithin, ConditionThatDeactivatesLeadsNowhere) {
    FakeMachine machine;
    machine.add("A", machine.transition("go", {"B"}));
    machine.start();
    machine.set("go", true);
    machine.guards["go"]->does = [&] { machine.core->deactivate(); };
    EXPECT_EQ(machine.cycle(), "go? A.exit");
    EXPECT_EQ(machine.core->status(), Status::inactive);
}

TEST(MachineWithin, EntryMayStartTheMachine) {
    FakeMachine machine;
    machine.program("A.entry").does = [&] { EXPECT_TRUE(machine.core->automatic()); };
    machine.core->activate();
    EXPECT_EQ(machine.core->status(), Status::running);
    EXPECT_EQ(machine.cycle(), "A.run A.handle A.run");
}

TEST(MachineWithin, StopAndPauseTakeEffectInTheNextCycle) {
    FakeMachine machine;
    machine.start();
    machine.program("A.handle").does = [&] { machine.core->stop(); };
    EXPECT_EQ(machine.cycle(), "A.handle A.run");
    EXPECT_EQ(machine.cycle(), "A.exit Z.entry");
    EXPECT_EQ(machine.core->status(), Status::stopped);
}

TEST(MachineWithin, RunThatMakesTheMachineReactiveEndsTheCycle) {
    FakeMachine machine;
    machine.add("A", machine.transition("go", {"B"}));
    machine.core->activate();
    machine.core->automatic();
    machine.program("A.run").does = [&] { machine.core->reactive(); };
    EXPECT_EQ(machine.cycle(), "A.run");
    EXPECT_EQ(machine.core->status(), Status::active);
}

}  // namespace
