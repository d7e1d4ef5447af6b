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
              "activating > paused, active > paused, requesting > paused, running > paused, stopping > paused, "
              "stopped > paused, resetting > paused, deactivating > deactivating, paused > paused, error > paused");
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
