// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_PENDING_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_PENDING_HPP

#include <rtt/scripting/detail/machine/machine_status.hpp>

namespace RTT::scripting::detail {

class MachineTransitions;

/** What a machine has to execute, in the order that MachineCore describes. */
class PendingWork {
public:
    PendingWork(MachineModel& model, MachineStatus& status, MachineTransitions& transitions)
        : model_(model), status_(status), transitions_(transitions) {}

    // -- What has to be executed ----------------------------------------------------------------------------
    /** The way into the first state. */
    void begin();
    /** Schedules `program`, if there is one, and the way to that state. `always`: ignores its preconditions. */
    void go(Routine* program, MachineState& to, bool always = false);
    /** Schedules the exit of the present state, and the way to that one. */
    void leaveFor(MachineState& to, bool always);
    void ignorePreconditions() { decided_ = true; }
    /** Schedules the exit, if it was not executed. */
    void scheduleExit();
    void scheduleRun();
    /** Schedules `handle` and `run` of the present state; what has begun goes on. */
    void scheduleRest();
    void dropRest() { handle_ = run_ = nullptr; }
    void drop();

    // -- Execution ------------------------------------------------------------------------------------------
    /** Sets variables to their initial values. False if that fails. */
    bool assignAll();
    /** True if nothing is left. Executes `run` at most once, because it may request itself again. */
    bool execute();
    /** Executes one statement; true if there was none. */
    bool executeStatement();
    bool finishExit() { return finish(exit_); }
    /** Finishes the transition and goes to the last state; true if it is there. */
    bool finishAtLast();
    void fail(const oroforge::diag::Location& where, const std::string& why);

    bool executing() const { return executing_ != nullptr; }
    bool isBusy() const { return run_ || handle_ || status_.inTransition(); }
    bool interruptible() const {
        return !status_.inTransition() && (!executing_ || executing_ == run_) && !(handle_ && handle_->started());
    }
    /** Lets nothing more be executed until scheduling begins anew, because a program called deactivate(). */
    void setLeaving(bool on) { leave_ = on; }
    bool leaving() const { return leave_; }

private:
    static void schedule(Routine*& slot, Routine* routine);
    void aim(MachineState& to, bool always);
    void enter(MachineState& state);
    bool assign(Routine* values);
    bool decide();
    bool finish(Routine*& slot);
    bool finishEntry();
    bool finishTransition();
    void updateInTransition() { status_.setInTransition(entering_ || program_ || next_ || exit_); }

    MachineModel& model_;
    MachineStatus& status_;
    MachineTransitions& transitions_;

    // Null if there is none.
    bool entering_ = false;  // locals_ and entry_ of the present state are pending
    Routine* locals_ = nullptr;
    Routine* entry_ = nullptr;
    Routine* program_ = nullptr;
    MachineState* next_ = nullptr;
    bool decided_ = false;     // the preconditions of next_ hold
    std::size_t detours_ = 0;  // number of detours on the way to next_
    Routine* exit_ = nullptr;  // exit of the present state, on the way to next_
    Routine* handle_ = nullptr;
    Routine* run_ = nullptr;

    Routine* executing_ = nullptr;
    bool entered_ = false;  // a state was entered in this pending work
    bool leave_ = false;
    bool left_ = false;  // the exit of the present state was executed, or failed
    bool single_ = false, stepped_ = false;
};

}  // namespace RTT::scripting::detail

#endif
