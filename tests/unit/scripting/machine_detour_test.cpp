// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Preconditions of a state that lead to another one: `preconditions { if c then select S }`.
#include "machine_fakes.hpp"

#include <gtest/gtest.h>

namespace {

using namespace machine_test;

class Detour : public testing::Test {
protected:
    Detour() { machine.add("A", machine.transition("go", {"B"})); }

    /** `of` is left for one of `to` if the guard of that name is true. */
    MachineTransition& detour(const char* of, const char* condition, const std::vector<std::string>& to,
                              const char* program = "") {
        machine.state(of).detours.push_back(machine.transition(condition, to, program));
        return machine.state(of).detours.back();
    }
    /** What happens when A is left for B. */
    std::string leave() {
        machine.start();
        machine.set("go", true);
        return machine.cycle();
    }

    FakeMachine machine;
};

TEST_F(Detour, IsLookedAtAfterTheExitOfTheStateBefore) {
    detour("B", "c", {"Z"});
    EXPECT_EQ(leave(), "go? A.exit c? B.entry") << "the condition does not hold";
    EXPECT_EQ(machine.stateName(), "B");
}

TEST_F(Detour, EntersTheOtherStateInstead) {
    detour("B", "c", {"Z"});
    machine.set("c", true);
    EXPECT_EQ(leave(), "go? A.exit c? Z.entry");
    EXPECT_EQ(machine.stateName(), "Z");
    EXPECT_EQ(machine.cycle(), "Z.run Z.handle Z.run");
}

TEST_F(Detour, FirstThatHoldsIsTaken) {
    detour("B", "one", {"Z"});
    detour("B", "two", {"A"});
    detour("B", "three", {"Z"});
    machine.set("two", true);
    machine.set("three", true);
    EXPECT_EQ(leave(), "go? A.exit one? two? A.entry") << "back to where it came from, which is entered anew";
}

TEST_F(Detour, ExecutesItsProgramBetweenExitAndEntry) {
    detour("B", "c", {"Z"}, "program");
    machine.set("c", true);
    machine.program("program").slices = 2;
    EXPECT_EQ(leave(), "go? A.exit c? program/1");
    EXPECT_TRUE(machine.core->inTransition());
    EXPECT_EQ(machine.cycle(), "program/2 Z.entry");
}

TEST_F(Detour, WithoutSelectionExecutesItsProgramAndEntersTheState) {
    detour("B", "c", {}, "program");
    detour("B", "never", {"Z"});
    machine.set("c", true);
    EXPECT_EQ(leave(), "go? A.exit c? program B.entry");
}

TEST_F(Detour, SelectingTheStateItselfEntersIt) {
    detour("B", "c", {"B"});
    machine.set("c", true);
    EXPECT_EQ(leave(), "go? A.exit c? B.entry");
}

TEST_F(Detour, TakesItsElse) {
    MachineTransition& made = detour("B", "c", {"A"});
    made.otherwise = std::make_unique<MachineSelection>();
    made.otherwise->states.push_back(&machine.state("Z"));
    EXPECT_EQ(leave(), "go? A.exit c? Z.entry");
}

TEST_F(Detour, LeadsToTheFirstStateWhosePreconditionsHold) {
    detour("B", "c", {"A", "Z"});
    machine.set("c", true);
    machine.state("A").preconditions.push_back(machine.guard("fit", true));
    machine.start();
    machine.set("fit", false);
    machine.set("go", true);
    EXPECT_EQ(machine.cycle(), "go? A.exit c? fit? Z.entry");
}

TEST_F(Detour, ToAStateThatMayNotBeEnteredIsNotTaken) {
    detour("B", "c", {"Z"});
    machine.set("c", true);
    machine.state("Z").preconditions.push_back(machine.guard("fit"));
    EXPECT_EQ(leave(), "go? A.exit c? fit? B.entry");
}

TEST_F(Detour, MayFollowAnother) {
    detour("B", "one", {"Z"}, "first");
    detour("Z", "two", {"A"}, "second");
    machine.set("one", true);
    machine.set("two", true);
    EXPECT_EQ(leave(), "go? A.exit one? first two? second A.entry");
}

TEST_F(Detour, WithoutEndIsAnError) {
    detour("B", "one", {"Z"});
    detour("Z", "two", {"B"});
    machine.set("one", true);
    machine.set("two", true);
    leave();
    EXPECT_EQ(machine.core->status(), Status::error);
    EXPECT_EQ(machine.failures,
              std::vector<std::string>{"50: preconditions lead from one state to the other without end"});
}

TEST_F(Detour, OfTheInitialStateIsTakenByActivate) {
    detour("A", "c", {"B"}, "program");
    machine.set("c", true);
    EXPECT_TRUE(machine.core->activate());
    EXPECT_EQ(machine.take(), "c? program B.entry") << "no state is left";
    EXPECT_EQ(machine.core->status(), Status::active);
    EXPECT_EQ(machine.stateName(), "B");
}

TEST_F(Detour, OfTheInitialStateIsTakenByReset) {
    machine.start();
    machine.core->stop();
    machine.cycle();
    detour("A", "c", {"B"});
    machine.set("c", true);
    machine.take();
    EXPECT_TRUE(machine.core->reset());
    EXPECT_EQ(machine.take(), "Z.exit c? B.entry");
}

TEST_F(Detour, IsTakenByRequestsAndEvents) {
    detour("B", "c", {"Z"});
    machine.set("c", true);
    machine.start();
    machine.set("go", true);
    EXPECT_TRUE(machine.core->requestState(machine.state("B")));
    EXPECT_EQ(machine.take(), "go? A.exit c? Z.entry");
}

TEST_F(Detour, OfTheFinalStateDoesNotKeepStopAndRequestsFromIt) {
    detour("Z", "", {"A"});
    machine.start();
    machine.core->stop();
    EXPECT_EQ(machine.cycle(), "A.exit Z.entry");
    EXPECT_TRUE(machine.core->automatic());
    machine.add("B", machine.transition("", {"Z"}));
    machine.core->deactivate();
    machine.start();
    machine.set("go", true);
    machine.cycle();
    ASSERT_EQ(machine.stateName(), "B");
    EXPECT_TRUE(machine.core->requestState(machine.state("Z")));
    EXPECT_EQ(machine.stateName(), "Z");
}

TEST_F(Detour, WhoseConditionFailsIsAnErrorAndTheExitIsNotRepeated) {
    detour("B", "c", {"Z"});
    machine.guards["c"]->truth = Guard::Truth::Failed;
    EXPECT_EQ(leave(), "go? A.exit c?");
    EXPECT_EQ(machine.core->status(), Status::error);
    machine.core->stop();
    EXPECT_EQ(machine.cycle(), "Z.entry");
    EXPECT_EQ(machine.core->status(), Status::stopped);
}

TEST_F(Detour, WhoseProgramWaitsDoesNotRepeatTheExitOfAMachineThatIsDeactivated) {
    detour("B", "c", {"Z"}, "program");
    machine.set("c", true);
    machine.program("program").slices = 3;
    EXPECT_EQ(leave(), "go? A.exit c? program/1");
    EXPECT_TRUE(machine.core->deactivate());
    EXPECT_EQ(machine.take(), "");
    EXPECT_EQ(machine.core->status(), Status::inactive);
    machine.set("go", false);
    machine.start();
    machine.core->deactivate();
    EXPECT_EQ(machine.take(), "A.exit") << "the next time it is executed";
}

TEST_F(Detour, DropsTheHandleOfTheStateBefore) {
    detour("B", "c", {"Z"}, "program");
    machine.set("c", true);
    machine.program("A.handle").slices = 2;
    machine.start();
    FakeEvent event(machine.trace);
    event.transition = machine.transition("", {"B"});
    ASSERT_TRUE(machine.core->happened(event));
    EXPECT_EQ(machine.cycle(), "A.exit c? program Z.entry");
}

}  // namespace
