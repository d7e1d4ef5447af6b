// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/machine/machine_transitions.hpp>

#include <rtt/scripting/detail/machine/machine_pending.hpp>

#include <algorithm>

namespace RTT::scripting::detail {

bool MachineTransitions::holds(Guard& guard) {
    Guard::Truth truth;
    {
        struct Looking {
            explicit Looking(bool& looking) : looking(looking) { looking = true; }
            ~Looking() { looking = false; }
            bool& looking;
        } const now(looking_);
        truth = guard.check(round_);
    }
    if (truth == Guard::Truth::Failed) pending_.fail(guard.where(), guard.failure());
    return truth == Guard::Truth::Yes;
}

bool MachineTransitions::preconditionsHold(const MachineState& state) {
    return std::all_of(state.preconditions.begin(), state.preconditions.end(),
                       [this](const GuardPtr& guard) { return holds(*guard); });
}

// Null if the transition may not be taken.
const MachineSelection* MachineTransitions::selected(const MachineTransition& transition) {
    if (transition.event && !holds(*transition.event)) return nullptr;
    if (!transition.condition || holds(*transition.condition)) return &transition.then;
    return status_.failed() ? nullptr : transition.otherwise.get();
}

MachineTransitions::Choice MachineTransitions::choose(const MachineTransition& transition, MachineState& present) {
    status_.setLine(transition.at.line);
    const MachineSelection* const selection = selected(transition);
    if (!selection) return {};
    if (selection->states.empty()) return {selection, &present};
    for (MachineState* state : selection->states) {
        // A machine that stays does not enter the state again.
        if (state == &present || preconditionsHold(*state)) return {selection, state};
        if (status_.failed()) break;
    }
    return {};
}

bool MachineTransitions::lookAtNext() {
    const std::vector<MachineTransition>& own = status_.present().transitions;
    const std::size_t count = own.size() + model_.transitions.size();
    if (looked_at_ == 0) beginRound();
    if (looked_at_ == count) {
        restart();
        pending_.scheduleRest();
        return true;
    }
    const MachineTransition& transition =
        looked_at_ < own.size() ? own[looked_at_] : model_.transitions[looked_at_ - own.size()];
    ++looked_at_;
    const Choice choice = choose(transition, status_.present());
    if (pending_.leaving() || status_.failed()) return true;
    if (choice.selection) pending_.go(choice.selection->program.get(), *choice.state);
    return choice.selection != nullptr;
}

bool MachineTransitions::goBy(const std::vector<MachineTransition>& transitions, MachineState& target) {
    const auto leadsThere = [&](const MachineSelection* selection) {
        return selection && std::count(selection->states.begin(), selection->states.end(), &target) != 0;
    };
    for (const MachineTransition& transition : transitions) {
        if (!leadsThere(&transition.then) && !leadsThere(transition.otherwise.get())) continue;
        const MachineSelection* const selection = selected(transition);
        if (pending_.leaving() || status_.failed()) return false;
        if (!leadsThere(selection) || !preconditionsHold(target)) continue;
        pending_.go(selection->program.get(), target);
        return true;
    }
    return false;
}

bool MachineTransitions::goTo(MachineState& target) {
    beginRound();
    return goBy(status_.present().transitions, target) || goBy(model_.transitions, target);
}

}  // namespace RTT::scripting::detail
