// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/machine/machine_pending.hpp>

#include <rtt/scripting/detail/machine/machine_transitions.hpp>

namespace RTT::scripting::detail {

typedef MachineStatus::Status Status;

void PendingWork::schedule(Routine*& slot, Routine* routine) {
    slot = routine;
    if (routine) routine->restart();
}

void PendingWork::scheduleRest() {
    MachineState& state = status_.present();
    if (!handle_ || !handle_->started()) schedule(handle_, state.handle.get());
    if (!run_ || !run_->started()) schedule(run_, state.run.get());
}

void PendingWork::scheduleRun() {
    if (!run_ || run_ != executing_) schedule(run_, status_.present().run.get());
}

void PendingWork::scheduleExit() {
    if (!left_) schedule(exit_, status_.present().exit.get());
    updateInTransition();
}

void PendingWork::aim(MachineState& to, bool always) {
    next_ = &to;
    decided_ = always;
    detours_ = 0;
}

void PendingWork::begin() {
    left_ = true;  // no state was entered
    aim(*model_.first, false);
    updateInTransition();
}

void PendingWork::leaveFor(MachineState& to, bool always) {
    aim(to, always);
    schedule(exit_, status_.present().exit.get());
    updateInTransition();
}

void PendingWork::go(Routine* program, MachineState& to, bool always) {
    MachineState& from = status_.present();
    transitions_.restart();
    schedule(program_, program);
    if (&to != &from) return leaveFor(to, always);
    if (!program)
        scheduleRest();
    else if (!run_)
        schedule(run_, from.run.get());
    updateInTransition();
}

void PendingWork::enter(MachineState& state) {
    next_ = nullptr;
    dropRest();
    status_.setState(&state);
    transitions_.restart();
    transitions_.beginRound();
    entering_ = true;
    left_ = false;
    schedule(locals_, state.locals.get());
    schedule(entry_, state.entry.get());
    updateInTransition();
    status_.tell("enters");
}

void PendingWork::drop() {
    entering_ = false;
    next_ = nullptr;
    transitions_.restart();
    for (Routine** slot : {&locals_, &entry_, &program_, &exit_, &handle_, &run_}) *slot = nullptr;
    updateInTransition();
}

void PendingWork::fail(const oroforge::diag::Location& where, const std::string& why) {
    drop();
    status_.fail(where, why);
}

bool PendingWork::assign(Routine* values) {
    Routine* left = values;
    if (left) left->restart();
    if (finish(left)) return true;
    // Routines of scripts continue after yields.
    if (left) fail(left->where(), "an initial value has to be there at once, but a function that gives it yields");
    return false;
}

bool PendingWork::assignAll() {
    for (const RoutinePtr& values : model_.initial)
        if (!assign(values.get())) return false;
    for (const MachineState& state : model_.states)
        if (!assign(state.locals.get())) return false;
    return true;
}

// Executes a routine; true if nothing is left of it.
bool PendingWork::finish(Routine*& slot) {
    Routine* const routine = slot;
    if (!routine) return true;
    if (stepped_ || leave_) return false;
    executing_ = routine;
    // Other threads may ask for the line while a call blocks.
    if (const unsigned line = routine->line()) status_.setLine(line);
    const Routine::Outcome outcome = single_ ? routine->runStatement() : routine->run();
    executing_ = nullptr;
    stepped_ = single_;
    if (outcome != Routine::Outcome::Finished) status_.setLine(routine->line());
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
bool PendingWork::decide() {
    decided_ = true;
    transitions_.beginRound();
    for (const MachineTransition& detour : next_->detours) {
        const MachineTransitions::Choice choice = transitions_.choose(detour, *next_);
        if (leave_ || status_.failed()) return false;
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

bool PendingWork::finishEntry() {
    if (!finish(locals_) || !finish(entry_)) return false;
    entering_ = false;
    entered_ = true;
    // Otherwise start() begins `run`.
    if (status_.now() != Status::activating && status_.now() != Status::resetting)
        schedule(run_, status_.present().run.get());
    return true;
}

bool PendingWork::finishTransition() {
    while (status_.inTransition()) {
        if (leave_) return false;
        if (entering_) {
            if (!finishEntry()) return false;
        } else {
            if (program_ && handle_ && handle_->started() && !finish(handle_)) return false;
            if (!finish(program_)) return false;
            if (next_) {
                if (!finish(exit_)) return false;
                left_ = true;
                dropRest();
                if (!decided_ && !decide()) return false;
                if (decided_ && !program_) enter(*next_);
            }
        }
        updateInTransition();
    }
    return true;
}

bool PendingWork::finishAtLast() {
    for (;;) {
        if (!finishTransition()) return false;
        if (&status_.present() == model_.last) break;
        go(nullptr, *model_.last, true);
        if (left_) exit_ = nullptr;
    }
    dropRest();
    return true;
}

bool PendingWork::execute() {
    entered_ = false;
    for (bool ran = false;;) {
        if (status_.inTransition() && (!finishTransition() || entered_)) return false;
        if (handle_) {
            if (!finish(handle_)) return false;
        } else {
            if (ran || !run_) return !run_ && !leave_;
            if (!finish(run_)) return false;
            ran = true;
        }
    }
}

bool PendingWork::executeStatement() {
    single_ = true;
    const bool idle = execute();
    const bool stepped = stepped_;
    single_ = stepped_ = false;
    return idle && !stepped;
}

}  // namespace RTT::scripting::detail
