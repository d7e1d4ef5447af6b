// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The order of execution in a state machine. Used by one thread at a time, which StateMachine ensures.
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_CORE_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_CORE_HPP

#include <rtt/scripting/detail/machine/machine_pending.hpp>
#include <rtt/scripting/detail/machine/machine_transitions.hpp>

namespace RTT::scripting::detail {

/**
 * One cycle of a machine that is running:
 *
 *     pending work    if some of it is left, the cycle ends
 *     transitions     of the state, then those of the machine, in the order of the text; the first that may be taken.
 *                     If there is none: `handle` and `run`
 *     pending work
 *
 * Pending work is, in this order; if a program yields, it and all that follows stay pending:
 *
 *     entry                  if an earlier cycle left it; the work ends there
 *     transition program     `handle` first, if that has begun
 *     exit                   of the state that is left; its `handle` and `run` are dropped
 *     preconditions          of the state to be entered; they may replace it by another state
 *     entry                  of the state that is entered; the work ends there
 *     handle, run
 *
 * Commands may also come from programs while they are executed ("within" below), and from events during calls.
 * Real-time safe, apart from what the script calls, and from failures.
 */
class MachineCore {
public:
    typedef MachineStatus::Status Status;
    typedef MachineStatus::Value StatusValue;

    MachineCore(MachineModel& model, MachineObserver& observer)
        : model_(model),
          status_(observer),
          pending_(model, status_, transitions_),
          transitions_(model, status_, pending_) {}

    // -- Any thread -----------------------------------------------------------------------------------------
    StatusValue status() const { return status_.value(); }
    MachineState* state() const { return status_.state(); }
    bool inTransition() const { return status_.inTransition(); }
    unsigned line() const { return status_.line(); }
    void setTraced(bool on) { status_.setTraced(on); }
    // These take effect in the next cycle.
    bool pause() { return status_.pause(); }
    bool step() { return status_.step(); }
    bool stop() { return status_.stop(); }

    // -- The thread that has the machine --------------------------------------------------------------------
    void cycle();
    /** True if cycle() would do nothing. */
    bool isIdle() const;
    bool activate();
    bool automatic();
    bool reactive();
    bool reset();
    bool deactivate();
    bool requestState(MachineState& target);
    /** Handles a call of an operation; true if a transition follows. */
    bool happened(MachineEvent& event);
    /** Goes to the final state, as stop() and the next cycle do, because the machine will be destroyed. */
    void stopNow();

private:
    bool within() const { return pending_.executing() || transitions_.looking(); }
    void takeRequests();
    void executeAndSettle();
    void settle();
    void cycleOfRunning();
    void beginStop();
    void continueStop();
    /** Leaves the state if the executed program called deactivate(). */
    void leaveIfAsked() {
        if (pending_.leaving() && !within()) beginDeactivation();
    }
    void beginDeactivation();
    void continueDeactivation();

    MachineModel& model_;
    MachineStatus status_;
    PendingWork pending_;
    MachineTransitions transitions_;
};

}  // namespace RTT::scripting::detail

#endif
