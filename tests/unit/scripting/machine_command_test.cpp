// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What each command does.
#include "machine_fakes.hpp"

#include <gtest/gtest.h>

namespace {

using namespace machine_test;

TEST(MachineCommand, ActivateEntersTheInitialStateAtOnce) {
    FakeMachine machine;
    EXPECT_TRUE(machine.core->activate());
    EXPECT_EQ(machine.take(), "A.entry");
    EXPECT_EQ(machine.stateName(), "A");
}

TEST(MachineCommand, ActivateAssignsParametersThenVariablesThenThoseOfStates) {
    FakeMachine machine;
    machine.model.initial.push_back(machine.routine("parameter"));
    machine.model.initial.push_back(machine.routine("variable"));
    machine.state("A").locals = machine.routine("A.locals");
    machine.state("B").locals = machine.routine("B.locals");
    machine.state("A").preconditions.push_back(machine.guard("fit", true));
    EXPECT_TRUE(machine.core->activate());
    EXPECT_EQ(machine.take(), "parameter variable A.locals B.locals fit? A.locals A.entry");
}

TEST(MachineCommand, ActivateIsFalseIfAPreconditionDoesNotHold) {
    FakeMachine machine;
    machine.state("A").preconditions.push_back(machine.guard("fit"));
    EXPECT_FALSE(machine.core->activate());
    EXPECT_EQ(machine.take(), "fit?");
    EXPECT_EQ(machine.core->status(), Status::inactive);
    machine.set("fit", true);
    EXPECT_TRUE(machine.core->activate());
}

TEST(MachineCommand, ActivateIsFalseIfAnInitialValueFails) {
    FakeMachine machine;
    machine.model.initial.push_back(machine.routine("parameter"));
    machine.program("parameter").fails = true;
    EXPECT_FALSE(machine.core->activate());
    EXPECT_EQ(machine.core->status(), Status::inactive);
    EXPECT_EQ(machine.failures, std::vector<std::string>{"101: parameter failed"});
}

TEST(MachineCommand, ActivateIsFalseIfAnInitialValueHasToWait) {
    FakeMachine machine;
    machine.model.initial.push_back(machine.routine("parameter"));
    machine.program("parameter").slices = 2;
    EXPECT_FALSE(machine.core->activate());
    EXPECT_EQ(machine.core->status(), Status::inactive);
    EXPECT_EQ(
        machine.failures,
        std::vector<std::string>{"101: an initial value has to be there at once, but a function that gives it yields"});
}

TEST(MachineCommand, ActivatingLastsAsLongAsTheEntryYields) {
    FakeMachine machine;
    machine.program("A.entry").slices = 3;
    EXPECT_TRUE(machine.core->activate());
    EXPECT_EQ(machine.take(), "A.entry/1");
    EXPECT_EQ(machine.core->status(), Status::activating);
    EXPECT_TRUE(machine.core->inTransition());
    EXPECT_EQ(machine.cycle(), "A.entry/2");
    EXPECT_EQ(machine.cycle(), "A.entry/3");
    EXPECT_EQ(machine.core->status(), Status::active);
    EXPECT_FALSE(machine.core->inTransition());
    EXPECT_EQ(machine.cycle(), "");
}

TEST(MachineCommand, ActivateDoesNotExecuteRunBeforeStart) {
    FakeMachine machine;
    machine.core->activate();
    machine.take();
    EXPECT_EQ(machine.cycle() + machine.cycle(), "");
    EXPECT_TRUE(machine.core->automatic());
    EXPECT_EQ(machine.cycle(), "A.run A.handle A.run");
}

TEST(MachineCommand, StartWhileItIsActivatingIsFollowedByRun) {
    FakeMachine machine;
    machine.program("A.entry").slices = 2;
    machine.core->activate();
    EXPECT_TRUE(machine.core->automatic());
    EXPECT_EQ(machine.cycle(), "A.entry/2");
    EXPECT_EQ(machine.cycle(), "A.run A.handle A.run");
}

TEST(MachineCommand, ActivateIsTrueThoughTheEntryFailed) {
    FakeMachine machine;
    machine.program("A.entry").fails = true;
    EXPECT_TRUE(machine.core->activate());
    EXPECT_EQ(machine.core->status(), Status::error);
    EXPECT_EQ(machine.failures, std::vector<std::string>{"101: A.entry failed"});
}

TEST(MachineCommand, AutomaticStartsRunFromItsBeginning) {
    FakeMachine machine;
    machine.program("A.run").slices = 3;
    machine.core->activate();
    machine.core->automatic();
    EXPECT_EQ(machine.cycle(), "A.run/1");
    EXPECT_EQ(machine.cycle(), "A.run/2");
    machine.core->automatic();
    EXPECT_EQ(machine.cycle(), "A.run/1");
}

TEST(MachineCommand, AutomaticAfterPauseGoesOnWhereItWas) {
    FakeMachine machine;
    machine.program("A.run").slices = 3;
    machine.core->activate();
    machine.core->automatic();
    EXPECT_EQ(machine.cycle(), "A.run/1");
    machine.core->pause();
    EXPECT_EQ(machine.cycle(), "");
    EXPECT_EQ(machine.cycle(), "");
    machine.core->automatic();
    EXPECT_EQ(machine.cycle(), "A.run/2");
}

TEST(MachineCommand, StepMayFollowAPauseThatHasNotTakenEffect) {
    FakeMachine machine;
    machine.add("A", machine.transition("go", {"B"}));
    machine.core->activate();
    machine.cycle();
    EXPECT_TRUE(machine.core->pause() && machine.core->step());
    EXPECT_FALSE(machine.core->step()) << "the last one is still to come";
    EXPECT_EQ(machine.core->status(), Status::active);
    EXPECT_EQ(machine.cycle(), "go?");
    EXPECT_EQ(machine.core->status(), Status::paused);
    EXPECT_EQ(machine.cycle(), "");
    machine.core->automatic();
    EXPECT_TRUE(machine.core->pause() && machine.core->step() && machine.core->stop()) << "takes both back";
    machine.cycle();
    EXPECT_EQ(machine.core->status(), Status::stopped);
    EXPECT_EQ(machine.cycle(), "");
}

TEST(MachineCommand, ReactiveMachinesDoNotLookAtTransitions) {
    FakeMachine machine;
    machine.add("A", machine.transition("go", {"B"}));
    machine.core->activate();
    machine.set("go", true);
    EXPECT_EQ(machine.cycle(), "");
    machine.core->automatic();
    machine.core->reactive();
    EXPECT_EQ(machine.cycle(), "A.run");
    EXPECT_EQ(machine.cycle(), "");
}

TEST(MachineCommand, StepOfAReactiveMachineLooksAtTheTransitionsOnce) {
    FakeMachine machine;
    machine.add("A", machine.transition("go", {"B"}));
    machine.core->activate();
    machine.core->cycle();
    machine.core->step();
    EXPECT_EQ(machine.cycle(), "go? A.handle A.run");
    EXPECT_EQ(machine.core->status(), Status::active);
    EXPECT_EQ(machine.cycle(), "");
    machine.set("go", true);
    machine.core->step();
    EXPECT_EQ(machine.cycle(), "go? A.exit B.entry");
    EXPECT_EQ(machine.cycle(), "B.run");
}

TEST(MachineCommand, StepOfAPausedMachineExecutesOneStatementOrLooksAtOneTransition) {
    FakeMachine machine;
    machine.program("A.exit").slices = 2;
    machine.add("A", machine.transition("one", {"B"}));
    machine.add("A", machine.transition("two", {"B"}));
    machine.start();
    machine.core->pause();
    EXPECT_EQ(machine.cycle(), "");
    const auto step = [&] {
        EXPECT_TRUE(machine.core->step());
        return machine.cycle();
    };
    EXPECT_EQ(step(), "one?");
    EXPECT_EQ(step(), "two?");
    EXPECT_EQ(step(), "");  // no transition: handle and run are scheduled
    EXPECT_EQ(step(), "A.handle");
    EXPECT_EQ(step(), "A.run");
    EXPECT_EQ(step(), "one?");
    machine.set("two", true);
    EXPECT_EQ(step(), "two?");
    EXPECT_EQ(step(), "A.exit/1");
    EXPECT_EQ(step(), "A.exit/2");
    EXPECT_EQ(step(), "B.entry");
    EXPECT_EQ(machine.cycle(), "");
    EXPECT_EQ(machine.core->status(), Status::paused);
}

TEST(MachineCommand, SecondStepIsRefusedUntilTheFirstIsDone) {
    FakeMachine machine;
    machine.start();
    machine.core->pause();
    machine.cycle();
    EXPECT_TRUE(machine.core->step());
    EXPECT_FALSE(machine.core->step());
    machine.cycle();
    EXPECT_TRUE(machine.core->step());
}

TEST(MachineCommand, StopGoesFromAnyStateToTheFinalOneWithoutTransition) {
    FakeMachine machine;
    machine.state("Z").preconditions.push_back(machine.guard("never"));
    machine.start();
    EXPECT_TRUE(machine.core->stop());
    EXPECT_EQ(machine.take(), "");
    EXPECT_EQ(machine.cycle(), "A.exit Z.entry");
    EXPECT_EQ(machine.core->status(), Status::stopped);
    EXPECT_EQ(machine.stateName(), "Z");
    EXPECT_EQ(machine.cycle(), "");
}

TEST(MachineCommand, StopInTheFinalStateEntersNothing) {
    FakeMachine machine;
    machine.start();
    machine.core->requestState(machine.state("Z"));
    EXPECT_EQ(machine.take(), "A.exit Z.entry");
    machine.core->stop();
    EXPECT_EQ(machine.cycle(), "");
    EXPECT_EQ(machine.core->status(), Status::stopped);
}

TEST(MachineCommand, StopWaitsForProgramsThatAreNoRunPrograms) {
    FakeMachine machine;
    machine.add("A", machine.transition("go", {"B"}));
    machine.program("B.entry").slices = 2;
    machine.program("B.exit").slices = 2;
    machine.start();
    machine.set("go", true);
    EXPECT_EQ(machine.cycle(), "go? A.exit B.entry/1");
    machine.core->stop();
    EXPECT_EQ(machine.core->status(), Status::stopping);
    EXPECT_EQ(machine.cycle(), "B.entry/2 B.exit/1");
    EXPECT_EQ(machine.cycle(), "B.exit/2 Z.entry");
    EXPECT_EQ(machine.core->status(), Status::stopped);
}

TEST(MachineCommand, StopInErrorGoesToTheFinalState) {
    FakeMachine machine;
    machine.program("A.run").fails = true;
    machine.core->activate();
    machine.core->automatic();
    EXPECT_EQ(machine.cycle(), "A.run");
    EXPECT_EQ(machine.core->status(), Status::error);
    EXPECT_EQ(machine.cycle(), "");
    machine.core->stop();
    EXPECT_EQ(machine.cycle(), "A.exit Z.entry");
    EXPECT_EQ(machine.core->status(), Status::stopped);
}

TEST(MachineCommand, StopDoesNotRepeatAnExitThatFailed) {
    FakeMachine machine;
    machine.start();
    machine.program("A.exit").fails = true;
    machine.core->stop();
    EXPECT_EQ(machine.cycle(), "A.exit");
    EXPECT_EQ(machine.core->status(), Status::error);
    machine.core->stop();
    EXPECT_EQ(machine.cycle(), "Z.entry");
    EXPECT_EQ(machine.core->status(), Status::stopped);
}

TEST(MachineCommand, ResetLeavesTheFinalStateForTheInitialOne) {
    FakeMachine machine;
    machine.start();
    machine.core->stop();
    machine.core->cycle();
    machine.take();
    EXPECT_TRUE(machine.core->reset());
    EXPECT_EQ(machine.take(), "Z.exit A.entry");
    EXPECT_EQ(machine.core->status(), Status::active);
    EXPECT_EQ(machine.cycle(), "") << "run begins with start()";
}

TEST(MachineCommand, ResetIsTrueThoughTheEntryFailed) {
    FakeMachine machine;
    machine.start();
    machine.core->stop();
    machine.core->cycle();
    machine.program("A.entry").fails = true;
    EXPECT_TRUE(machine.core->reset());
    EXPECT_EQ(machine.core->status(), Status::error);
}

TEST(MachineCommand, DeactivateExecutesTheExitOfTheStateAndDropsTheRest) {
    FakeMachine machine;
    machine.program("A.run").slices = 2;
    machine.start();
    EXPECT_TRUE(machine.core->deactivate());
    EXPECT_EQ(machine.take(), "A.exit");
    EXPECT_EQ(machine.core->status(), Status::inactive);
    EXPECT_EQ(machine.stateName(), "");
    EXPECT_EQ(machine.cycle(), "");
}

TEST(MachineCommand, DeactivateOfAMachineInErrorExecutesNothing) {
    FakeMachine machine;
    machine.program("A.run").fails = true;
    machine.start();
    EXPECT_EQ(machine.core->status(), Status::error);
    EXPECT_TRUE(machine.core->deactivate());
    EXPECT_EQ(machine.take(), "");
    EXPECT_EQ(machine.core->status(), Status::inactive);
}

TEST(MachineCommand, DeactivatingLastsAsLongAsTheExitYields) {
    FakeMachine machine;
    machine.program("A.exit").slices = 3;
    machine.start();
    machine.core->deactivate();
    EXPECT_EQ(machine.take(), "A.exit/1");
    EXPECT_EQ(machine.core->status(), Status::deactivating);
    EXPECT_EQ(machine.cycle(), "A.exit/2");
    EXPECT_EQ(machine.cycle(), "A.exit/3");
    EXPECT_EQ(machine.core->status(), Status::inactive);
}

TEST(MachineCommand, SecondDeactivateDropsAnExitThatStalls) {
    FakeMachine machine;
    machine.program("A.exit").slices = 1000;
    machine.start();
    machine.core->deactivate();
    machine.take();
    EXPECT_TRUE(machine.core->deactivate());
    EXPECT_EQ(machine.take(), "");
    EXPECT_EQ(machine.core->status(), Status::inactive);
    EXPECT_TRUE(machine.core->activate());
    EXPECT_EQ(machine.take(), "A.entry");
}

TEST(MachineCommand, LineIsThatOfTheProgramOrTransition) {
    FakeMachine machine;
    machine.add("A", machine.transition("go", {"B"}));
    machine.state("A").handle = nullptr;
    machine.state("A").run = nullptr;
    EXPECT_EQ(machine.core->line(), 0u);
    machine.program("A.entry").slices = 2;
    machine.core->activate();
    EXPECT_EQ(machine.core->line(), 101u);
    machine.core->automatic();
    machine.cycle();
    machine.cycle();
    EXPECT_EQ(machine.core->line(), 50u);
    machine.core->deactivate();
    EXPECT_EQ(machine.core->line(), 0u);
}

TEST(MachineCommand, LineIsThatOfAProgramBeforeItsEndToo) {
    FakeMachine machine;
    unsigned inside = 0;
    machine.program("A.run").does = [&] { inside = machine.core->line(); };
    machine.core->activate();
    machine.core->automatic();
    machine.cycle();
    EXPECT_EQ(inside, 100u);
}

TEST(MachineCommand, LineIsNoneAfterAnActivationThatFailed) {
    FakeMachine machine;
    machine.model.initial.push_back(machine.routine("parameter"));
    machine.program("parameter").fails = true;
    EXPECT_FALSE(machine.core->activate());
    EXPECT_EQ(machine.core->line(), 0u);
}

TEST(MachineCommand, TraceTellsWhatHappens) {
    FakeMachine machine;
    machine.core->setTraced(true);
    machine.start();
    machine.core->requestState(machine.state("Z"));
    machine.cycle();
    machine.core->deactivate();
    EXPECT_EQ(machine.told, (std::vector<std::string>{"enters A", "runs in A", "was asked to go to Z", "enters Z",
                                                      "deactivates in Z"}));
}

}  // namespace
