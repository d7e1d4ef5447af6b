// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/machine/machine_core.hpp>

namespace RTT::scripting::detail {

Routine::~Routine() = default;
Guard::~Guard() = default;
MachineEvent::~MachineEvent() = default;

void MachineCore::cycle() {
    if (status_.hasRequests()) takeRequests();
    switch (status_.now()) {
        case Status::running: cycleOfRunning(); break;
        case Status::active:
        case Status::activating:
        case Status::resetting:
        case Status::stopped:
            pending_.execute();
            settle();
            break;
        case Status::requesting:
            if (!pending_.execute()) break;
            status_.set(Status::active);
            transitions_.look();
            pending_.execute();
            break;
        case Status::stopping: continueStop(); break;
        case Status::deactivating: continueDeactivation(); break;
        case Status::paused:
        case Status::inactive:
        case Status::error:
        case Status::unloaded: break;
    }
    leaveIfAsked();
}

bool MachineCore::isIdle() const {
    if (status_.hasRequests() || pending_.leaving()) return false;
    switch (status_.now()) {
        case Status::inactive:
        case Status::error:
        case Status::paused: return true;
        case Status::stopped: return !pending_.isBusy();
        default: return false;
    }
}

void MachineCore::takeRequests() {
    const StatusValue now = status_.now();
    const unsigned requests = status_.takeRequests();
    if (now == Status::inactive || now == Status::deactivating) {
        status_.cancelRequests();
    } else if (requests & MachineStatus::kStop) {
        beginStop();
    } else {
        if ((requests & MachineStatus::kPause) && now != Status::paused) {
            status_.set(Status::paused);
            status_.tell("pauses in");
        }
        if ((requests & MachineStatus::kStep) && status_.now() == Status::paused && pending_.executeStatement())
            transitions_.lookAtNext();
    }
}

void MachineCore::cycleOfRunning() {
    if (pending_.isBusy() && (!pending_.execute() || status_.now() != Status::running)) return;
    transitions_.look();
    pending_.execute();
}

// Activating and resetting end with the entry of the initial state.
void MachineCore::settle() {
    const StatusValue now = status_.now();
    if (!status_.inTransition() && (now == Status::activating || now == Status::resetting)) status_.set(Status::active);
}

void MachineCore::executeAndSettle() {
    pending_.execute();
    settle();
    leaveIfAsked();
}

bool MachineCore::activate() {
    if (status_.now() != Status::inactive || within()) return false;
    status_.cancelRequests();
    transitions_.beginRound();
    if (!pending_.assignAll() || !transitions_.preconditionsHold(*model_.first)) {
        status_.set(Status::inactive);
        status_.setLine(0);
        return false;
    }
    status_.set(Status::activating);
    status_.setState(model_.first);
    pending_.begin();
    executeAndSettle();
    return true;
}

bool MachineCore::automatic() {
    const StatusValue now = status_.now();
    if (now == Status::inactive || now == Status::error || now == Status::deactivating) return false;
    status_.cancelRequests();
    status_.set(Status::running);
    status_.tell("runs in");
    if (now != Status::paused && !status_.inTransition()) pending_.scheduleRun();
    return true;
}

bool MachineCore::reactive() {
    const StatusValue now = status_.now();
    if (now == Status::inactive || now == Status::error || now == Status::deactivating) return false;
    status_.cancelRequests();
    status_.set(Status::active);
    status_.tell("is reactive in");
    return true;
}

bool MachineCore::reset() {
    if (status_.now() != Status::stopped || within()) return false;
    pending_.drop();
    status_.set(Status::resetting);
    pending_.leaveFor(*model_.first, false);
    executeAndSettle();
    return true;
}

bool MachineCore::requestState(MachineState& target) {
    const StatusValue now = status();
    const bool ready = now == Status::active || now == Status::running || now == Status::requesting ||
                       now == Status::paused || now == Status::stopped;
    if (!ready || !pending_.interruptible() || transitions_.looking()) return false;
    const MachineState* const present = status_.state();
    if (&target == present) {
        pending_.scheduleRest();
        return true;
    }
    if (!transitions_.goTo(target)) {
        const bool always = &target == model_.last || (&target == model_.first && present == model_.last);
        if (!always || pending_.leaving() || status_.failed()) return leaveIfAsked(), false;
        pending_.go(nullptr, target);
    }
    if (&target == model_.last) pending_.ignorePreconditions();
    if (now == Status::stopped) status_.set(Status::resetting);
    status_.tell("was asked to go to", target);
    // Not at once within its own programs, or while it is paused.
    if (!within() && now != Status::paused) executeAndSettle();
    return true;
}

bool MachineCore::happened(MachineEvent& event) {
    const StatusValue now = status();
    const bool ready =
        now == Status::active || now == Status::running || now == Status::requesting || now == Status::paused;
    MachineState* const present = status_.state();
    if (!ready || inTransition() || transitions_.looking() || (event.state && event.state != present)) return false;
    event.receive();
    transitions_.beginRound();
    const MachineTransitions::Choice choice = transitions_.choose(event.transition, *present);
    if (!choice.selection || pending_.leaving()) return leaveIfAsked(), false;
    pending_.go(choice.selection->program.get(), *choice.state);
    status_.tell("leaves by an event", *present);
    return true;
}

void MachineCore::beginStop() {
    const StatusValue now = status_.now();
    if (now == Status::stopped || now == Status::stopping) return;
    // An error ends everything that had begun; otherwise only what may be interrupted ends.
    if (now == Status::error) pending_.drop();
    pending_.dropRest();
    status_.set(Status::stopping);
    status_.tell("stops in");
}

void MachineCore::continueStop() {
    if (pending_.finishAtLast() && status_.now() == Status::stopping) status_.set(Status::stopped);
}

void MachineCore::stopNow() {
    if (within()) return;
    beginStop();
    continueStop();
    leaveIfAsked();
}

bool MachineCore::deactivate() {
    const StatusValue now = status_.now();
    if (now == Status::inactive) return false;
    if (!within()) {
        // An exit program that did not end is given up.
        if (now == Status::deactivating) pending_.drop();
        beginDeactivation();
    } else if (now != Status::deactivating) {
        pending_.setLeaving(true);
        status_.set(Status::deactivating);
    }
    return true;
}

void MachineCore::beginDeactivation() {
    const StatusValue now = status_.now();
    const bool stalled = now == Status::deactivating && !pending_.leaving();
    pending_.setLeaving(false);
    pending_.drop();
    status_.cancelRequests();
    status_.set(Status::deactivating);
    status_.tell("deactivates in");
    if (!stalled && now != Status::error) pending_.scheduleExit();
    continueDeactivation();
}

void MachineCore::continueDeactivation() {
    if (!pending_.finishExit()) return;
    pending_.drop();
    status_.setState(nullptr);
    status_.setLine(0);
    status_.set(Status::inactive);
}

}  // namespace RTT::scripting::detail
