// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Selects the next state by transitions, events and requests.
#include <rtt/scripting/detail/machine/machine_core.hpp>

#include <algorithm>

namespace RTT::scripting::detail {

/** Marks that a condition is being evaluated, which may call code that commands this machine. */
class MachineCore::Looking {
public:
    explicit Looking(MachineCore& core) : core_(core) { core_.looking_ = true; }
    ~Looking() { core_.looking_ = false; }
    Looking(const Looking&) = delete;
    Looking& operator=(const Looking&) = delete;

private:
    MachineCore& core_;
};

bool MachineCore::holds(Guard& guard) {
    Guard::Truth truth;
    {
        const Looking looking(*this);
        truth = guard.check(round_);
    }
    if (truth == Guard::Truth::Failed) fail(guard.where(), guard.failure());
    return truth == Guard::Truth::Yes;
}

bool MachineCore::preconditionsHold(const MachineState& state) {
    return std::all_of(state.preconditions.begin(), state.preconditions.end(),
                       [this](const GuardPtr& guard) { return holds(*guard); });
}

// Null if the transition may not be taken.
const MachineSelection* MachineCore::selected(const MachineTransition& transition) {
    if (transition.event && !holds(*transition.event)) return nullptr;
    if (!transition.condition || holds(*transition.condition)) return &transition.then;
    return status_.load(std::memory_order_relaxed) == Status::error ? nullptr : transition.otherwise.get();
}

MachineCore::Choice MachineCore::choose(const MachineTransition& transition, MachineState& present) {
    line_.store(transition.at.line, std::memory_order_relaxed);
    const MachineSelection* const selection = selected(transition);
    if (!selection) return {};
    if (selection->states.empty()) return {selection, &present};
    for (MachineState* state : selection->states) {
        // A machine that stays does not enter the state again.
        if (state == &present || preconditionsHold(*state)) return {selection, state};
        if (status_.load(std::memory_order_relaxed) == Status::error) break;
    }
    return {};
}

void MachineCore::look() {
    while (!lookAtNext()) {
    }
}

// True when the round is over.
bool MachineCore::lookAtNext() {
    const std::vector<MachineTransition>& own = current_.load(std::memory_order_relaxed)->transitions;
    const std::size_t count = own.size() + model_.transitions.size();
    if (looked_at_ == 0) ++round_;
    if (looked_at_ == count) {
        looked_at_ = 0;
        scheduleRest();
        return true;
    }
    const MachineTransition& transition =
        looked_at_ < own.size() ? own[looked_at_] : model_.transitions[looked_at_ - own.size()];
    ++looked_at_;
    const Choice choice = choose(transition, *current_.load(std::memory_order_relaxed));
    if (leave_ || status_.load(std::memory_order_relaxed) == Status::error) return true;
    if (choice.selection) go(choice.selection->program.get(), *choice.state);
    return choice.selection != nullptr;
}

bool MachineCore::interruptible() const {
    return !inTransition() && !looking_ && (!executing_ || executing_ == run_) && !(handle_ && handle_->started());
}

bool MachineCore::goBy(const std::vector<MachineTransition>& transitions, MachineState& target) {
    const auto leadsThere = [&](const MachineSelection* selection) {
        return selection && std::count(selection->states.begin(), selection->states.end(), &target) != 0;
    };
    for (const MachineTransition& transition : transitions) {
        if (!leadsThere(&transition.then) && !leadsThere(transition.otherwise.get())) continue;
        const MachineSelection* const selection = selected(transition);
        if (leave_ || status_.load(std::memory_order_relaxed) == Status::error) return false;
        if (!leadsThere(selection) || !preconditionsHold(target)) continue;
        go(selection->program.get(), target);
        return true;
    }
    return false;
}

bool MachineCore::requestState(MachineState& target) {
    const StatusValue now = status();
    const bool ready = now == Status::active || now == Status::running || now == Status::requesting ||
                       now == Status::paused || now == Status::stopped;
    if (!ready || !interruptible()) return false;
    MachineState* const present = current_.load(std::memory_order_relaxed);
    if (&target == present) {
        scheduleRest();
        return true;
    }
    ++round_;
    if (!goBy(present->transitions, target) && !goBy(model_.transitions, target)) {
        const bool always = &target == model_.last || (&target == model_.first && present == model_.last);
        if (!always || leave_ || status_.load() == Status::error) return leaveIfAsked(), false;
        go(nullptr, target);
    }
    if (&target == model_.last) decided_ = true;
    if (now == Status::stopped) setStatus(Status::resetting);
    tell("was asked to go to", target.name);
    // Not at once within its own programs, or while it is paused.
    if (within() || now == Status::paused) return true;
    executePending();
    settle();
    leaveIfAsked();
    return true;
}

bool MachineCore::happened(MachineEvent& event) {
    const StatusValue now = status();
    const bool ready =
        now == Status::active || now == Status::running || now == Status::requesting || now == Status::paused;
    MachineState* const present = current_.load(std::memory_order_relaxed);
    if (!ready || inTransition() || looking_ || (event.state && event.state != present)) return false;
    event.receive();
    ++round_;
    const Choice choice = choose(event.transition, *present);
    if (!choice.selection || leave_) return leaveIfAsked(), false;
    go(choice.selection->program.get(), *choice.state);
    tell("leaves by an event", present->name);
    return true;
}

}  // namespace RTT::scripting::detail
