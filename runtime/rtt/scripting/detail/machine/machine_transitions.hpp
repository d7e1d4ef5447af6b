// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_TRANSITIONS_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_TRANSITIONS_HPP

#include <rtt/scripting/detail/machine/machine_status.hpp>

#include <vector>

namespace RTT::scripting::detail {

class PendingWork;

/** Selects the next state. Conditions may fail, which status tells, and call deactivate(). */
class MachineTransitions {
public:
    MachineTransitions(MachineModel& model, MachineStatus& status, PendingWork& pending)
        : model_(model), status_(status), pending_(pending) {}

    struct Choice {
        const MachineSelection* selection = nullptr;
        MachineState* state = nullptr;
    };
    /** Begins a round, in which conditions that read ports read them once. */
    void beginRound() { ++round_; }
    /** `present` is the state in which it stays if nothing is selected. */
    Choice choose(const MachineTransition& transition, MachineState& present);
    bool preconditionsHold(const MachineState& state);
    /** Looks at the next transition of the round; true if that is over. Then the first that may be taken is taken, or
        the rest of the state scheduled. */
    bool lookAtNext();
    void look() {
        while (!lookAtNext()) {
        }
    }
    /** The next round begins with the first transition. */
    void restart() { looked_at_ = 0; }
    /** Takes a transition that leads to that state; false if there is none. */
    bool goTo(MachineState& target);
    /** True while a condition is evaluated, which may call code that commands this machine. */
    bool looking() const { return looking_; }

private:
    bool holds(Guard& guard);
    const MachineSelection* selected(const MachineTransition& transition);
    bool goBy(const std::vector<MachineTransition>& transitions, MachineState& target);

    MachineModel& model_;
    MachineStatus& status_;
    PendingWork& pending_;
    bool looking_ = false;
    unsigned round_ = 0;
    std::size_t looked_at_ = 0;  // number of transitions checked in this round
};

}  // namespace RTT::scripting::detail

#endif
