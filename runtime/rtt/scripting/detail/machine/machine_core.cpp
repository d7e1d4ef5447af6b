// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Commands, and their effects in a cycle.
#include <rtt/scripting/detail/machine/machine_core.hpp>

namespace RTT::scripting::detail {

Routine::~Routine() = default;
Guard::~Guard() = default;
MachineEvent::~MachineEvent() = default;
MachineObserver::~MachineObserver() = default;

MachineCore::StatusValue MachineCore::status() const {
    const StatusValue now = status_.load(std::memory_order_acquire);
    const bool stops = requests_.load(std::memory_order_relaxed) & kStop;
    return stops && now != Status::inactive && now != Status::deactivating ? Status::stopping : now;
}

bool MachineCore::pause() {
    const StatusValue now = status();
    if (now == Status::inactive || now == Status::deactivating) return false;
    requests_.fetch_or(kPause, std::memory_order_release);
    return true;
}

bool MachineCore::step() {
    // A step may follow a pause that has not taken effect.
    unsigned requests = requests_.load(std::memory_order_relaxed);
    while ((requests & kPause) && !(requests & kStop)) {
        if (requests & kStep) return false;
        if (requests_.compare_exchange_weak(requests, requests | kStep, std::memory_order_release,
                                            std::memory_order_relaxed))
            return true;
    }
    const StatusValue now = status();
    if (now == Status::paused) return !(requests_.fetch_or(kStep, std::memory_order_release) & kStep);
    StatusValue expected = Status::active;
    return now == Status::active && status_.compare_exchange_strong(expected, Status::requesting);
}

bool MachineCore::stop() {
    const StatusValue now = status();
    if (now == Status::inactive || now == Status::deactivating) return false;
    if (now == Status::stopped)
        requests_.fetch_and(kStop, std::memory_order_relaxed);
    else
        requests_.store(kStop, std::memory_order_release);
    return true;
}

void MachineCore::cycle() {
    if (requests_.load(std::memory_order_relaxed)) takeRequests();
    switch (status_.load(std::memory_order_relaxed)) {
        case Status::running: cycleOfRunning(); break;
        case Status::active:
        case Status::activating:
        case Status::resetting:
        case Status::stopped:
            executePending();
            settle();
            break;
        case Status::requesting:
            if (!executePending()) break;
            setStatus(Status::active);
            look();
            executePending();
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
    if (requests_.load(std::memory_order_relaxed) || leave_) return false;
    switch (status_.load(std::memory_order_relaxed)) {
        case Status::inactive:
        case Status::error:
        case Status::paused: return true;
        case Status::stopped: return !isBusy();
        default: return false;
    }
}

void MachineCore::takeRequests() {
    const StatusValue now = status_.load(std::memory_order_relaxed);
    unsigned requests = requests_.load(std::memory_order_relaxed), later;
    do {
        const bool stops = (requests & kStop) || now == Status::stopping;
        later = stops ? requests & kPause : 0;
    } while (!requests_.compare_exchange_weak(requests, later, std::memory_order_acquire, std::memory_order_relaxed));
    requests &= ~later;
    if (now == Status::inactive || now == Status::deactivating) {
        requests_ = 0;
    } else if (requests & kStop) {
        beginStop();
    } else {
        if ((requests & kPause) && now != Status::paused) {
            setStatus(Status::paused);
            tell("pauses in", current_.load()->name);
        }
        if ((requests & kStep) && status_.load(std::memory_order_relaxed) == Status::paused) cycleOfPaused();
    }
}

void MachineCore::cycleOfRunning() {
    if (isBusy() && (!executePending() || status_.load(std::memory_order_relaxed) != Status::running)) return;
    look();
    executePending();
}

void MachineCore::cycleOfPaused() {
    single_ = true;
    const bool idle = executePending();
    const bool stepped = stepped_;
    single_ = stepped_ = false;
    if (idle && !stepped) lookAtNext();
}

// Activating and resetting end with the entry of the initial state.
void MachineCore::settle() {
    const StatusValue now = status_.load(std::memory_order_relaxed);
    if (!inTransition() && (now == Status::activating || now == Status::resetting)) setStatus(Status::active);
}

bool MachineCore::assign(Routine* values) {
    Routine* left = values;
    if (left) left->restart();
    if (finish(left)) return true;
    // Routines of scripts continue after yields.
    if (left) fail(left->where(), "an initial value has to be there at once, but a function that gives it yields");
    return false;
}

bool MachineCore::assignAll() {
    for (const RoutinePtr& values : model_.initial)
        if (!assign(values.get())) return false;
    for (const MachineState& state : model_.states)
        if (!assign(state.locals.get())) return false;
    return true;
}

bool MachineCore::activate() {
    if (status_.load() != Status::inactive || within()) return false;
    requests_ = 0;
    ++round_;
    if (!assignAll() || !preconditionsHold(*model_.first)) {
        setStatus(Status::inactive);
        line_ = 0;
        return false;
    }
    setStatus(Status::activating);
    current_ = model_.first;
    left_ = true;  // no state was entered
    aim(*model_.first, false);
    updateInTransition();
    executePending();
    settle();
    leaveIfAsked();
    return true;
}

bool MachineCore::automatic() {
    const StatusValue now = status_.load();
    if (now == Status::inactive || now == Status::error || now == Status::deactivating) return false;
    requests_ = 0;
    setStatus(Status::running);
    tell("runs in", current_.load()->name);
    if (now == Status::paused || inTransition() || (run_ && run_ == executing_)) return true;
    schedule(run_, current_.load()->run.get());
    return true;
}

bool MachineCore::reactive() {
    const StatusValue now = status_.load();
    if (now == Status::inactive || now == Status::error || now == Status::deactivating) return false;
    requests_ = 0;
    setStatus(Status::active);
    tell("is reactive in", current_.load()->name);
    return true;
}

bool MachineCore::reset() {
    if (status_.load() != Status::stopped || within()) return false;
    drop();
    setStatus(Status::resetting);
    aim(*model_.first, false);
    schedule(exit_, current_.load()->exit.get());
    updateInTransition();
    executePending();
    settle();
    leaveIfAsked();
    return true;
}

void MachineCore::beginStop() {
    const StatusValue now = status_.load();
    if (now == Status::stopped || now == Status::stopping) return;
    // An error ends everything that had begun; otherwise only what may be interrupted ends.
    if (now == Status::error) drop();
    handle_ = run_ = nullptr;
    setStatus(Status::stopping);
    tell("stops in", current_.load()->name);
}

void MachineCore::continueStop() {
    for (;;) {
        if (!finishTransition()) return;
        if (current_.load() == model_.last) break;
        go(nullptr, *model_.last, true);
        if (left_) exit_ = nullptr;
    }
    handle_ = run_ = nullptr;
    if (status_.load() == Status::stopping) setStatus(Status::stopped);
}

void MachineCore::stopNow() {
    if (within()) return;
    beginStop();
    continueStop();
    leaveIfAsked();
}

bool MachineCore::deactivate() {
    const StatusValue now = status_.load();
    if (now == Status::inactive) return false;
    if (!within()) {
        // An exit program that did not end is given up.
        if (now == Status::deactivating) drop();
        beginDeactivation();
    } else if (now != Status::deactivating) {
        leave_ = true;
        setStatus(Status::deactivating);
    }
    return true;
}

void MachineCore::beginDeactivation() {
    const StatusValue now = status_.load();
    const bool stalled = now == Status::deactivating && !leave_;
    leave_ = false;
    drop();
    requests_ = 0;
    setStatus(Status::deactivating);
    tell("deactivates in", current_.load()->name);
    if (!stalled && !left_ && now != Status::error) schedule(exit_, current_.load()->exit.get());
    updateInTransition();
    continueDeactivation();
}

void MachineCore::continueDeactivation() {
    if (!finish(exit_)) return;
    drop();
    current_ = nullptr;
    line_ = 0;
    left_ = false;
    setStatus(Status::inactive);
}

}  // namespace RTT::scripting::detail
