// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Which command is accepted in which status.
#include "machine_fakes.hpp"

#include <gtest/gtest.h>

#include <ostream>

namespace {

using namespace machine_test;

typedef MachineCore::StatusValue Value;

const Value kAll[] = {Status::inactive,     Status::activating, Status::active,  Status::requesting,
                      Status::running,      Status::stopping,   Status::stopped, Status::resetting,
                      Status::deactivating, Status::paused,     Status::error};
const char* const kNames[] = {"inactive", "activating", "active",       "requesting", "running", "stopping",
                              "stopped",  "resetting",  "deactivating", "paused",     "error"};

/** Brings a new machine into a status. What is under way there needs two more cycles. */
void bring(FakeMachine& machine, Value status) {
    MachineCore& core = *machine.core;
    switch (status) {
        case Status::inactive: break;
        case Status::activating:
            machine.program("A.entry").slices = 3;
            core.activate();
            break;
        case Status::active: core.activate(); break;
        case Status::requesting:
            core.activate();
            core.step();
            break;
        case Status::running: machine.start(); break;
        case Status::stopping:
            machine.program("Z.entry").slices = 3;
            machine.start();
            core.stop();
            core.cycle();
            break;
        case Status::stopped:
            machine.start();
            core.stop();
            core.cycle();
            break;
        case Status::resetting:
            bring(machine, Status::stopped);
            machine.program("A.entry").slices = 3;
            core.reset();
            break;
        case Status::deactivating:
            machine.program("A.exit").slices = 3;
            machine.start();
            core.deactivate();
            break;
        case Status::paused:
            machine.start();
            core.pause();
            core.cycle();
            break;
        case Status::error:
            machine.program("A.run").fails = true;
            core.activate();
            core.automatic();
            core.cycle();
            break;
        case Status::unloaded: break;
    }
    ASSERT_EQ(core.status(), status) << "while bringing it into " << kNames[status];
    machine.take();
}

typedef std::function<bool(FakeMachine&)> Command;

/** The statuses in which a command is accepted, and, for those, the status it leads to at once. */
std::string accepted(const Command& command) {
    std::string result;
    for (const Value status : kAll) {
        FakeMachine machine;
        bring(machine, status);
        const bool done = command(machine);
        const Value after = machine.core->status();
        if (done) result += std::string(result.empty() ? "" : ", ") + kNames[status] + " > " + kNames[after];
        EXPECT_TRUE(done || after == status)
            << "a command that is refused changes nothing, but did in " << kNames[status];
    }
    return result;
}

TEST(MachineCommandTable, ActivateIsForInactiveMachines) {
    EXPECT_EQ(accepted([](FakeMachine& m) { return m.core->activate(); }), "inactive > active");
}

TEST(MachineCommandTable, AutomaticIsForAllThatAreActiveAndNotInError) {
    EXPECT_EQ(accepted([](FakeMachine& m) { return m.core->automatic(); }),
              "activating > running, active > running, requesting > running, running > running, stopping > running, "
              "stopped > running, resetting > running, paused > running");
}

TEST(MachineCommandTable, ReactiveIsForAllThatAreActiveAndNotInError) {
    EXPECT_EQ(accepted([](FakeMachine& m) { return m.core->reactive(); }),
              "activating > active, active > active, requesting > active, running > active, stopping > active, "
              "stopped > active, resetting > active, paused > active");
}

TEST(MachineCommandTable, StepIsForPausedAndActiveMachines) {
    EXPECT_EQ(accepted([](FakeMachine& m) { return m.core->step(); }), "active > requesting, paused > paused");
}

TEST(MachineCommandTable, PauseTakesEffectInTheNextCycle) {
    EXPECT_EQ(accepted([](FakeMachine& m) { return m.core->pause(); }),
              "activating > activating, active > active, requesting > requesting, running > running, "
              "stopping > stopping, stopped > stopped, resetting > resetting, paused > paused, error > error");
    EXPECT_EQ(accepted([](FakeMachine& m) {
                  const bool done = m.core->pause();
                  m.core->cycle();
                  return done || m.core->status() != Status::inactive;
              }),
              "activating > paused, active > paused, requesting > paused, running > paused, stopping > stopping, "
              "stopped > paused, resetting > paused, deactivating > deactivating, paused > paused, error > paused");
}

/** The status after each of `cycles` cycles. */
std::string statusIn(FakeMachine& machine, int cycles) {
    std::string result;
    for (int i = 0; i != cycles; ++i) {
        machine.core->cycle();
        result += std::string(i ? ", " : "") + kNames[machine.core->status()];
    }
    return result;
}

TEST(MachineCommandTable, StopTakesBackAPauseThatWasAskedFor) {
    for (const Value status :
         {Status::active, Status::requesting, Status::running, Status::stopped, Status::paused, Status::error}) {
        FakeMachine machine;
        bring(machine, status);
        EXPECT_TRUE(machine.core->pause());
        EXPECT_TRUE(machine.core->stop());
        EXPECT_EQ(statusIn(machine, 2), "stopped, stopped") << kNames[status];
        EXPECT_EQ(machine.stateName(), "Z") << kNames[status];
    }
}

TEST(MachineCommandTable, PauseWaitsForAStopThatWasAskedFor) {
    for (const Value status :
         {Status::active, Status::requesting, Status::running, Status::stopped, Status::paused, Status::error}) {
        FakeMachine machine;
        bring(machine, status);
        EXPECT_TRUE(machine.core->stop());
        EXPECT_TRUE(machine.core->pause());
        machine.core->cycle();
        EXPECT_EQ(machine.stateName(), "Z") << kNames[status];
        EXPECT_EQ(statusIn(machine, 2), "paused, paused") << kNames[status];
    }
}

TEST(MachineCommandTable, PauseWaitsForAStopThatHasBegun) {
    FakeMachine machine;
    bring(machine, Status::stopping);
    EXPECT_TRUE(machine.core->pause());
    EXPECT_EQ(statusIn(machine, 3), "stopping, stopped, paused");
}

TEST(MachineCommandTable, StopTakesBackAPauseThatWaitsForTheStop) {
    FakeMachine machine;
    bring(machine, Status::stopping);
    EXPECT_TRUE(machine.core->pause());
    EXPECT_TRUE(machine.core->stop());
    EXPECT_EQ(statusIn(machine, 3), "stopping, stopped, stopped");
}

TEST(MachineCommandTable, StopTakesBackAStep) {
    FakeMachine machine;
    bring(machine, Status::paused);
    machine.add("A", machine.transition("asked", {"B"}));
    EXPECT_TRUE(machine.core->step());
    EXPECT_TRUE(machine.core->stop());
    EXPECT_FALSE(machine.core->step()) << "it is stopping";
    EXPECT_EQ(machine.cycle(), "A.exit Z.entry");
    EXPECT_EQ(machine.core->status(), Status::stopped);
}

TEST(MachineCommandTable, PauseDoesNotTakeBackAStep) {
    FakeMachine machine;
    machine.add("A", machine.transition("asked", {"B"}));
    bring(machine, Status::paused);
    EXPECT_TRUE(machine.core->step());
    EXPECT_TRUE(machine.core->pause());
    EXPECT_EQ(machine.cycle(), "asked?");
    EXPECT_EQ(machine.core->status(), Status::paused);
}

TEST(MachineCommandTable, StartTakesBackAPauseAndAStop) {
    FakeMachine machine;
    bring(machine, Status::running);
    machine.core->stop();
    machine.core->pause();
    EXPECT_TRUE(machine.core->automatic());
    EXPECT_EQ(statusIn(machine, 2), "running, running");
    EXPECT_EQ(machine.stateName(), "A");
}

TEST(MachineCommandTable, FailureIsNotHiddenByAPauseThatWaitsForTheStop) {
    FakeMachine machine;
    bring(machine, Status::running);
    machine.program("A.exit").fails = true;
    machine.core->stop();
    machine.core->pause();
    EXPECT_EQ(statusIn(machine, 2), "error, error");
}

TEST(MachineCommandTable, StopIsForAllThatAreActive) {
    EXPECT_EQ(accepted([](FakeMachine& m) { return m.core->stop(); }),
              "activating > stopping, active > stopping, requesting > stopping, running > stopping, "
              "stopping > stopping, stopped > stopped, resetting > stopping, paused > stopping, error > stopping");
}

TEST(MachineCommandTable, ResetIsForStoppedMachines) {
    EXPECT_EQ(accepted([](FakeMachine& m) { return m.core->reset(); }), "stopped > active");
}

TEST(MachineCommandTable, DeactivateIsForAllButInactiveMachines) {
    EXPECT_EQ(accepted([](FakeMachine& m) { return m.core->deactivate(); }),
              "activating > inactive, active > inactive, requesting > inactive, running > inactive, "
              "stopping > inactive, stopped > inactive, resetting > inactive, deactivating > inactive, "
              "paused > inactive, error > inactive");
}

TEST(MachineCommandTable, RequestOfTheFinalStateIsForMachinesThatAreInAState) {
    EXPECT_EQ(accepted([](FakeMachine& m) { return m.core->requestState(m.state("Z")); }),
              "active > active, requesting > requesting, running > running, stopped > stopped, paused > paused");
}

}  // namespace
