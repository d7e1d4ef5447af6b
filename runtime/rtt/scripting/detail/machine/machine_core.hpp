// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The order of execution in a state machine. Used by one thread at a time, which StateMachine ensures.
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_CORE_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_CORE_HPP

#include <rtt/scripting/StateMachine.hpp>
#include <rtt/scripting/detail/machine/machine_model.hpp>

#include <diag/diagnostic.hpp>

#include <atomic>
#include <string>

namespace RTT::scripting::detail {

/** Observes a machine. Called in the thread that executes it. */
class MachineObserver {
public:
    virtual ~MachineObserver();
    /** `what` and the name of a state. Only called while traced. */
    virtual void did(const char* what, const std::string& state) = 0;
    virtual void failed(const oroforge::diag::Location& where, const std::string& why) = 0;
};

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
    typedef StateMachine::Status Status;
    typedef StateMachine::StateMachineStatus StatusValue;

    MachineCore(MachineModel& model, MachineObserver& observer) : model_(model), observer_(observer) {}

    // -- Any thread -----------------------------------------------------------------------------------------
    StatusValue status() const;
    MachineState* state() const { return current_.load(std::memory_order_acquire); }
    bool inTransition() const { return in_transition_.load(std::memory_order_acquire); }
    unsigned line() const { return line_.load(std::memory_order_relaxed); }
    void setTraced(bool on) { traced_.store(on, std::memory_order_relaxed); }
    // These take effect in the next cycle.
    bool pause();
    bool step();
    bool stop();

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
    struct Choice {
        const MachineSelection* selection = nullptr;
        MachineState* state = nullptr;
    };
    /** Requests that have not taken effect. kStop is the first: stop() cancels earlier requests, and a later pause
        waits for it. */
    enum Request : unsigned { kPause = 1, kStep = 2, kStop = 4 };
    class Looking;

    // machine_core.cpp: commands
    void setStatus(StatusValue status) { status_.store(status, std::memory_order_release); }
    bool within() const { return executing_ || looking_; }
    void takeRequests();
    void beginStop();
    void continueStop();
    /** Leaves the state if the executed program called deactivate(). */
    void leaveIfAsked() {
        if (leave_ && !within()) beginDeactivation();
    }
    bool isBusy() const { return run_ || handle_ || inTransition(); }
    void beginDeactivation();
    void continueDeactivation();
    void settle();
    void cycleOfRunning();
    void cycleOfPaused();
    bool assign(Routine* values);
    bool assignAll();

    // machine_pending.cpp: what has to be executed
    void schedule(Routine*& slot, Routine* routine);
    void scheduleRest();
    void enter(MachineState& state);
    /** Schedules `program`, if there is one, and the way to that state. `always`: ignores its preconditions. */
    void go(Routine* program, MachineState& to, bool always = false);
    void aim(MachineState& to, bool always);
    bool decide();
    void drop();
    void updateInTransition();
    bool finish(Routine*& slot);
    bool finishTransition();
    bool executePending();
    void fail(const oroforge::diag::Location& where, const std::string& why);
    void tell(const char* what, const std::string& state);

    // machine_transitions.cpp: where to go
    void look();
    bool lookAtNext();
    /** `present` is the state in which it stays if nothing is selected. */
    Choice choose(const MachineTransition& transition, MachineState& present);
    bool holds(Guard& guard);
    bool preconditionsHold(const MachineState& state);
    const MachineSelection* selected(const MachineTransition& transition);
    bool interruptible() const;
    bool goBy(const std::vector<MachineTransition>& transitions, MachineState& target);

    MachineModel& model_;
    MachineObserver& observer_;
    std::atomic<StatusValue> status_{Status::inactive};
    std::atomic<MachineState*> current_{nullptr};
    std::atomic<unsigned> requests_{0};
    std::atomic<unsigned> line_{0};
    std::atomic<bool> in_transition_{false};
    std::atomic<bool> traced_{false};

    // Pending work; null if there is none.
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
    bool looking_ = false;  // evaluating a condition
    bool entered_ = false;  // a state was entered in this pending work
    bool leave_ = false;    // deactivate() was called within a program
    bool left_ = false;     // the exit of the present state was executed, or failed
    bool single_ = false, stepped_ = false;
    unsigned round_ = 0;
    std::size_t looked_at_ = 0;  // number of transitions checked in this round
};

}  // namespace RTT::scripting::detail

#endif
