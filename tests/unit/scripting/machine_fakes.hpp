// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A state machine of programs and conditions that write down what is executed.
#ifndef OROFORGE_TESTS_SCRIPTING_MACHINE_FAKES_HPP
#define OROFORGE_TESTS_SCRIPTING_MACHINE_FAKES_HPP

#include <rtt/scripting/detail/machine/machine_core.hpp>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace machine_test {

using namespace RTT::scripting;
using namespace RTT::scripting::detail;

typedef MachineCore::Status Status;

/** Writes its name with each slice; takes several if it yields in between. */
class FakeRoutine final : public Routine {
public:
    FakeRoutine(std::string name, std::string& trace) : name_(std::move(name)), trace_(trace) {}

    int slices = 1;
    bool fails = false;  // in its last slice
    std::function<void()> does;

    void restart() override { done_ = 0, started_ = false; }
    Outcome run() override {
        started_ = true;
        trace_ += (trace_.empty() ? "" : " ") + name_ + (slices > 1 ? "/" + std::to_string(done_ + 1) : "");
        if (does) does();
        if (++done_ < slices) return Outcome::Yielded;
        if (fails) return Outcome::Failed;
        restart();
        return Outcome::Finished;
    }
    Outcome runStatement() override { return run(); }
    bool started() const override { return started_; }
    unsigned line() const override { return 100 + static_cast<unsigned>(done_); }
    oroforge::diag::Location where() const override { return {"fake.ops", line(), 1}; }
    std::string failure() const override { return name_ + " failed"; }

private:
    const std::string name_;
    std::string& trace_;
    int done_ = 0;
    bool started_ = false;
};

/** Writes its name and "?" when it is asked. */
class FakeGuard final : public Guard {
public:
    FakeGuard(std::string name, std::string& trace) : name_(std::move(name)), trace_(trace) {}

    Truth truth = Truth::No;
    std::function<void()> does;
    std::vector<unsigned> rounds;

    Truth check(unsigned round) override {
        trace_ += (trace_.empty() ? "" : " ") + name_ + "?";
        rounds.push_back(round);
        if (does) does();
        return truth;
    }
    oroforge::diag::Location where() const override { return {"fake.ops", 7, 3}; }
    std::string failure() const override { return name_ + " cannot be told"; }

private:
    const std::string name_;
    std::string& trace_;
};

/** States A (initial), B and Z (final) with all programs. Transitions are added by the tests. */
class FakeMachine : public MachineObserver {
public:
    FakeMachine() {
        for (const char* name : {"A", "B", "Z"}) {
            MachineState& state = model.states.emplace_back();
            state.name = name;
            state.entry = routine(state.name + ".entry");
            state.run = routine(state.name + ".run");
            state.handle = routine(state.name + ".handle");
            state.exit = routine(state.name + ".exit");
        }
        model.first = &model.states[0];
        model.last = &model.states[2];
        core = std::make_unique<MachineCore>(model, *this);
    }

    std::string trace;
    std::vector<std::string> failures, told;
    std::map<std::string, FakeRoutine*> routines;
    std::map<std::string, FakeGuard*> guards;
    MachineModel model;
    std::unique_ptr<MachineCore> core;

    MachineState& state(const std::string& name) {
        for (MachineState& each : model.states)
            if (each.name == name) return each;
        throw std::runtime_error("no state " + name);
    }
    RoutinePtr routine(const std::string& name) {
        auto made = std::make_unique<FakeRoutine>(name, trace);
        routines[name] = made.get();
        return made;
    }
    FakeRoutine& program(const std::string& name) { return *routines.at(name); }
    GuardPtr guard(const std::string& name, bool truth = false) {
        auto made = std::make_unique<FakeGuard>(name, trace);
        made->truth = truth ? Guard::Truth::Yes : Guard::Truth::No;
        guards[name] = made.get();
        return made;
    }
    void set(const std::string& name, bool truth) {
        guards.at(name)->truth = truth ? Guard::Truth::Yes : Guard::Truth::No;
    }
    /** `from` → `to` (no name: stays) if the guard of that name is true (no name: always). */
    MachineTransition transition(const std::string& condition, const std::vector<std::string>& to,
                                 const std::string& withProgram = "") {
        MachineTransition made;
        made.at.line = 50;
        if (!condition.empty()) made.condition = guard(condition);
        for (const std::string& name : to) made.then.states.push_back(&state(name));
        if (!withProgram.empty()) made.then.program = routine(withProgram);
        return made;
    }
    void add(const std::string& from, MachineTransition transition) {
        (from.empty() ? model.transitions : state(from).transitions).push_back(std::move(transition));
    }

    /** What was executed since the last time. */
    std::string take() {
        std::string taken;
        taken.swap(trace);
        return taken;
    }
    std::string cycle() {
        take();
        core->cycle();
        return take();
    }
    std::string stateName() const { return core->state() ? core->state()->name : ""; }
    /** Active in A, its `run` done. */
    void start() {
        core->activate();
        core->automatic();
        core->cycle();
        take();
    }

    void did(const char* what, const std::string& state) override { told.push_back(std::string(what) + ' ' + state); }
    void failed(const oroforge::diag::Location& where, const std::string& why) override {
        failures.push_back(std::to_string(where.line) + ": " + why);
    }
};

/** Does nothing with arguments. */
class FakeEvent final : public MachineEvent {
public:
    explicit FakeEvent(std::string& trace) : trace_(trace) {}
    void receive() override { trace_ += (trace_.empty() ? "" : " ") + std::string("received"); }

private:
    std::string& trace_;
};

}  // namespace machine_test

#endif
