// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Executes pending work in order.
#include <rtt/scripting/detail/machine/machine_core.hpp>

namespace RTT::scripting::detail {

void MachineCore::schedule(Routine*& slot, Routine* routine) {
    slot = routine;
    if (routine) routine->restart();
}

// Schedules `handle` and `run` of the present state; what has begun goes on.
void MachineCore::scheduleRest() {
    MachineState& state = *current_.load(std::memory_order_relaxed);
    if (!handle_ || !handle_->started()) schedule(handle_, state.handle.get());
    if (!run_ || !run_->started()) schedule(run_, state.run.get());
}

void MachineCore::aim(MachineState& to, bool always) {
    next_ = &to;
    decided_ = always;
    detours_ = 0;
}

void MachineCore::go(Routine* program, MachineState& to, bool always) {
    MachineState& from = *current_.load(std::memory_order_relaxed);
    looked_at_ = 0;
    schedule(program_, program);
    if (&to != &from) {
        aim(to, always);
        schedule(exit_, from.exit.get());
    } else if (!program) {
        scheduleRest();
    } else if (!run_) {
        schedule(run_, from.run.get());
    }
    updateInTransition();
}

void MachineCore::enter(MachineState& state) {
    next_ = nullptr;
    handle_ = run_ = nullptr;
    current_.store(&state, std::memory_order_release);
    looked_at_ = 0;
    ++round_;
    entering_ = true;
    left_ = false;
    schedule(locals_, state.locals.get());
    schedule(entry_, state.entry.get());
    updateInTransition();
    tell("enters", state.name);
}

void MachineCore::drop() {
    entering_ = false;
    next_ = nullptr;
    looked_at_ = 0;
    for (Routine** slot : {&locals_, &entry_, &program_, &exit_, &handle_, &run_}) *slot = nullptr;
    updateInTransition();
}

void MachineCore::updateInTransition() {
    in_transition_.store(entering_ || program_ || next_ || exit_, std::memory_order_release);
}

// Executes a routine; true if nothing is left of it.
bool MachineCore::finish(Routine*& slot) {
    Routine* const routine = slot;
    if (!routine) return true;
    if (stepped_ || leave_) return false;
    executing_ = routine;
    // Other threads may ask for the line while a call blocks.
    if (const unsigned line = routine->line()) line_.store(line, std::memory_order_relaxed);
    const Routine::Outcome outcome = single_ ? routine->runStatement() : routine->run();
    executing_ = nullptr;
    stepped_ = single_;
    if (outcome != Routine::Outcome::Finished) line_.store(routine->line(), std::memory_order_relaxed);
    if (outcome == Routine::Outcome::Failed) {
        left_ = left_ || &slot == &exit_;
        slot = nullptr;
        fail(routine->where(), routine->failure());
        return false;
    }
    if (outcome != Routine::Outcome::Finished) return false;
    if (slot == routine) slot = nullptr;
    return !leave_;
}

/** Checks whether preconditions of the state to be entered lead to another one. False if that fails. */
bool MachineCore::decide() {
    decided_ = true;
    ++round_;
    for (const MachineTransition& detour : next_->detours) {
        const Choice choice = choose(detour, *next_);
        if (leave_ || status_.load(std::memory_order_relaxed) == Status::error) return false;
        if (!choice.selection) continue;
        if (choice.state != next_ && ++detours_ > model_.states.size()) {
            fail({model_.source ? model_.source->name : oroforge::diag::FileName(), detour.at.line, detour.at.column},
                 "preconditions lead from one state to the other without end");
            return false;
        }
        schedule(program_, choice.selection->program.get());
        decided_ = choice.state == next_;
        next_ = choice.state;
        break;
    }
    return true;
}

bool MachineCore::finishTransition() {
    while (inTransition()) {
        if (leave_) return false;
        if (entering_) {
            if (!finish(locals_) || !finish(entry_)) return false;
            entering_ = false;
            entered_ = true;
            // Otherwise start() begins `run`.
            const StatusValue now = status_.load(std::memory_order_relaxed);
            if (now != Status::activating && now != Status::resetting)
                schedule(run_, current_.load(std::memory_order_relaxed)->run.get());
        } else {
            if (program_ && handle_ && handle_->started() && !finish(handle_)) return false;
            if (!finish(program_)) return false;
            if (next_) {
                if (!finish(exit_)) return false;
                left_ = true;
                handle_ = run_ = nullptr;
                if (!decided_ && !decide()) return false;
                if (decided_ && !program_) enter(*next_);
            }
        }
        updateInTransition();
    }
    return true;
}

// True if nothing is left. Executes `run` at most once, because it may request itself again.
bool MachineCore::executePending() {
    entered_ = false;
    for (bool ran = false;;) {
        if (inTransition() && (!finishTransition() || entered_)) return false;
        if (handle_) {
            if (!finish(handle_)) return false;
        } else {
            if (ran || !run_) return !run_ && !leave_;
            if (!finish(run_)) return false;
            ran = true;
        }
    }
}

void MachineCore::fail(const oroforge::diag::Location& where, const std::string& why) {
    drop();
    // An earlier pause or step must not hide the error.
    requests_.fetch_and(kStop, std::memory_order_relaxed);
    setStatus(Status::error);
    observer_.failed(where, why);
}

void MachineCore::tell(const char* what, const std::string& state) {
    if (traced_.load(std::memory_order_relaxed)) observer_.did(what, state);
}

}  // namespace RTT::scripting::detail
