// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// requestState() rule by rule, and events.
#include "machine_fakes.hpp"

#include <gtest/gtest.h>

namespace {

using namespace machine_test;

class Request : public testing::Test {
protected:
    FakeMachine machine;
    bool request(const std::string& state) { return machine.core->requestState(machine.state(state)); }
};

TEST_F(Request, OfThePresentStateHandlesAndRuns) {
    machine.core->activate();
    machine.core->cycle();
    EXPECT_TRUE(request("A"));
    EXPECT_EQ(machine.cycle(), "A.handle A.run");
    EXPECT_EQ(machine.cycle(), "");
}

TEST_F(Request, TakesTheFirstTransitionToTheStateWhoseConditionHolds) {
    machine.add("A", machine.transition("one", {"B"}, "program1"));
    machine.add("A", machine.transition("elsewhere", {"Z"}));
    machine.add("A", machine.transition("two", {"B"}, "program2"));
    machine.start();
    EXPECT_FALSE(request("B"));
    EXPECT_EQ(machine.take(), "one? two?");
    machine.set("two", true);
    EXPECT_TRUE(request("B"));
    EXPECT_EQ(machine.take(), "one? two? program2 A.exit B.entry") << "at once";
    EXPECT_FALSE(machine.core->inTransition());
    EXPECT_EQ(machine.stateName(), "B");
    EXPECT_EQ(machine.cycle(), "B.run B.handle B.run");
}

TEST_F(Request, TakesTransitionsOfTheMachineAfterThoseOfTheState) {
    machine.add("", machine.transition("global", {"B"}));
    machine.add("A", machine.transition("own", {"B"}));
    machine.start();
    machine.set("global", true);
    EXPECT_TRUE(request("B"));
    EXPECT_EQ(machine.take(), "own? global? A.exit B.entry");
}

TEST_F(Request, TakesAnElse) {
    MachineTransition transition = machine.transition("go", {"Z"});
    transition.otherwise = std::make_unique<MachineSelection>();
    transition.otherwise->states.push_back(&machine.state("B"));
    machine.add("A", std::move(transition));
    machine.core->activate();
    EXPECT_TRUE(request("B"));
    EXPECT_EQ(machine.take(), "A.entry go? A.exit B.entry");
}

TEST_F(Request, NeedsThePreconditionsOfTheState) {
    machine.add("A", machine.transition("go", {"B"}));
    machine.state("B").preconditions.push_back(machine.guard("fit"));
    machine.start();
    machine.set("go", true);
    EXPECT_FALSE(request("B"));
    EXPECT_EQ(machine.take(), "go? fit?");
    machine.set("fit", true);
    EXPECT_TRUE(request("B"));
}

TEST_F(Request, OfTheFinalStateNeedsNoTransitionAndNoPrecondition) {
    machine.state("Z").preconditions.push_back(machine.guard("never"));
    machine.start();
    EXPECT_TRUE(request("Z"));
    EXPECT_EQ(machine.take(), "A.exit Z.entry");
    EXPECT_EQ(machine.core->status(), Status::running);
}

TEST_F(Request, OfTheFinalStateTakesAPossibleTransitionFirst) {
    machine.add("A", machine.transition("go", {"Z"}, "program"));
    machine.start();
    machine.set("go", true);
    EXPECT_TRUE(request("Z"));
    EXPECT_EQ(machine.take(), "go? program A.exit Z.entry");
}

TEST_F(Request, OfTheInitialStateIsPossibleInTheFinalOneOnly) {
    machine.add("A", machine.transition("", {"B"}));
    machine.core->activate();
    machine.core->automatic();
    machine.cycle();
    ASSERT_EQ(machine.stateName(), "B");
    EXPECT_FALSE(request("A"));
    EXPECT_TRUE(request("Z"));
    machine.cycle();
    machine.take();
    EXPECT_TRUE(request("A"));
    EXPECT_EQ(machine.take(), "Z.exit A.entry");
}

TEST_F(Request, WakesAStoppedMachine) {
    machine.start();
    machine.core->stop();
    machine.cycle();
    machine.program("A.entry").slices = 2;
    EXPECT_TRUE(request("A"));
    EXPECT_EQ(machine.take(), "Z.exit A.entry/1");
    EXPECT_EQ(machine.core->status(), Status::resetting);
    EXPECT_EQ(machine.cycle(), "A.entry/2");
    EXPECT_EQ(machine.core->status(), Status::active);
}

TEST_F(Request, InterruptsRunWhichIsDropped) {
    machine.program("A.run").slices = 3;
    machine.core->activate();
    machine.core->automatic();
    EXPECT_EQ(machine.cycle(), "A.run/1");
    EXPECT_TRUE(request("Z"));
    EXPECT_EQ(machine.take(), "A.exit Z.entry");
    EXPECT_EQ(machine.cycle(), "Z.run Z.handle Z.run");
}

TEST_F(Request, OfAPausedMachineWaitsUntilItGoesOn) {
    machine.start();
    machine.core->pause();
    machine.cycle();
    EXPECT_TRUE(request("Z"));
    EXPECT_EQ(machine.take() + machine.cycle(), "");
    machine.core->automatic();
    EXPECT_EQ(machine.cycle(), "A.exit Z.entry");
}

TEST_F(Request, IsAcceptedThoughTheEntryFails) {
    machine.start();
    machine.program("Z.entry").fails = true;
    EXPECT_TRUE(request("Z"));
    EXPECT_EQ(machine.core->status(), Status::error);
}

TEST_F(Request, DoesNotInterruptHandle) {
    machine.program("A.handle").slices = 2;
    machine.start();
    EXPECT_EQ(machine.cycle(), "A.handle/2 A.run A.handle/1");
    EXPECT_FALSE(request("Z"));
    EXPECT_EQ(machine.stateName(), "A");
}

TEST_F(Request, IsRefusedInATransition) {
    machine.program("A.exit").slices = 2;
    machine.start();
    EXPECT_TRUE(request("Z"));
    EXPECT_EQ(machine.take(), "A.exit/1");
    EXPECT_FALSE(request("Z"));
    EXPECT_FALSE(request("A"));
    EXPECT_EQ(machine.cycle(), "A.exit/2 Z.entry");
    EXPECT_TRUE(request("A"));
}

class Event : public Request {
protected:
    std::unique_ptr<FakeEvent> event;
    /** In state A, if `guard`, to B. */
    void make(const char* guard, const char* state = "A") {
        event = std::make_unique<FakeEvent>(machine.trace);
        event->transition = machine.transition(guard, {"B"}, "program");
        event->state = state ? &machine.state(state) : nullptr;
    }
    bool happens() { return machine.core->happened(*event); }
};

TEST_F(Event, ReceivesThenAsksThenSchedules) {
    make("go");
    machine.start();
    machine.set("go", true);
    EXPECT_TRUE(happens());
    EXPECT_EQ(machine.take(), "received go?");
    EXPECT_EQ(machine.stateName(), "A");
    EXPECT_EQ(machine.cycle(), "program A.exit B.entry");
}

TEST_F(Event, IsAcceptedByAReactiveMachine) {
    make("");
    machine.core->activate();
    EXPECT_TRUE(happens());
    EXPECT_EQ(machine.cycle(), "program A.exit B.entry");
    EXPECT_EQ(machine.cycle(), "B.run");
}

TEST_F(Event, IsLostIfItsConditionDoesNotHold) {
    make("go");
    machine.start();
    EXPECT_FALSE(happens());
    EXPECT_EQ(machine.take(), "received go?");
    machine.set("go", true);
    EXPECT_EQ(machine.cycle(), "A.handle A.run");
}

TEST_F(Event, TakesTheElse) {
    make("go");
    event->transition.otherwise = std::make_unique<MachineSelection>();
    event->transition.otherwise->states.push_back(&machine.state("Z"));
    machine.start();
    EXPECT_TRUE(happens());
    EXPECT_EQ(machine.cycle(), "A.exit Z.entry");
}

TEST_F(Event, NeedsThePreconditions) {
    make("");
    machine.state("B").preconditions.push_back(machine.guard("fit"));
    machine.start();
    EXPECT_FALSE(happens());
    EXPECT_EQ(machine.take(), "received fit?");
}

TEST_F(Event, OfAnotherStateIsNotEvenReceived) {
    make("", "B");
    machine.start();
    EXPECT_FALSE(happens());
    EXPECT_EQ(machine.take(), "");
}

TEST_F(Event, OfTheMachineIsAcceptedInAnyState) {
    make("", nullptr);
    machine.start();
    machine.core->requestState(machine.state("Z"));
    machine.cycle();
    EXPECT_TRUE(happens());
    EXPECT_EQ(machine.cycle(), "program Z.exit B.entry");
}

TEST_F(Event, IsLostInATransition) {
    make("", nullptr);
    machine.program("A.exit").slices = 2;
    machine.start();
    machine.core->requestState(machine.state("Z"));
    EXPECT_FALSE(happens());
    EXPECT_EQ(machine.cycle(), "A.exit/2 Z.entry");
}

TEST_F(Event, IsLostUnlessTheMachineIsActive) {
    make("", nullptr);
    EXPECT_FALSE(happens());
    machine.start();
    machine.core->stop();
    EXPECT_FALSE(happens());
    machine.cycle();
    EXPECT_FALSE(happens()) << "stopped";
    machine.core->deactivate();
    EXPECT_FALSE(happens());
}

TEST_F(Event, CompletesAHandleInProgressBeforeTheProgram) {
    make("");
    machine.program("A.handle").slices = 2;
    machine.start();
    ASSERT_TRUE(happens());
    EXPECT_EQ(machine.cycle(), "A.handle/2 program A.exit B.entry");
}

TEST_F(Event, WithoutProgramDropsAHandleInProgress) {
    make("");
    event->transition.then.program.reset();
    machine.program("A.handle").slices = 2;
    machine.start();
    ASSERT_TRUE(happens());
    EXPECT_EQ(machine.cycle(), "A.exit B.entry");
}

TEST_F(Event, ToSelfExecutesItsProgramWhileRunGoesOn) {
    make("");
    event->transition.then.states.clear();
    machine.program("A.run").slices = 3;
    machine.core->activate();
    machine.core->automatic();
    EXPECT_EQ(machine.cycle(), "A.run/1");
    ASSERT_TRUE(happens());
    EXPECT_EQ(machine.cycle(), "program A.run/2");
}

TEST_F(Event, DuringRunIsFollowedAtOnce) {
    make("");
    machine.start();
    machine.program("A.run").does = [&] { EXPECT_TRUE(happens()); };
    EXPECT_EQ(machine.cycle(), "A.handle A.run received program A.exit B.entry");
}

TEST_F(Event, DuringAConditionIsLost) {
    make("");
    machine.add("A", machine.transition("go", {"Z"}));
    machine.start();
    machine.guards["go"]->does = [&] { EXPECT_FALSE(happens()); };
    EXPECT_EQ(machine.cycle(), "go? A.handle A.run");
}

TEST_F(Event, WhosConditionFailsIsAnError) {
    make("go");
    machine.start();
    machine.guards["go"]->truth = Guard::Truth::Failed;
    EXPECT_FALSE(happens());
    EXPECT_EQ(machine.core->status(), Status::error);
}

}  // namespace
