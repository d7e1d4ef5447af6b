// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/machine/machine_service.hpp>

#include <rtt/types/TypeInfo.hpp>

namespace RTT::scripting::detail {

namespace {

template <class Result>
struct Call {
    MachineSlot slot;
    Result (StateMachine::*function)();
    Result operator()() const {
        const StateMachinePtr machine = slot->lock();
        return machine ? (machine.get()->*function)() : Result();
    }
};

template <class Result, class Argument>
struct CallWith {
    MachineSlot slot;
    Result (StateMachine::*function)(Argument);
    Result operator()(Argument argument) const {
        const StateMachinePtr machine = slot->lock();
        return machine ? (machine.get()->*function)(argument) : Result();
    }
};

template <class Result>
struct Query {
    MachineSlot slot;
    Result (StateMachine::*function)() const;
    Result operator()() const {
        const StateMachinePtr machine = slot->lock();
        return machine ? (machine.get()->*function)() : Result();
    }
};

struct InState {
    MachineSlot slot;
    bool operator()(const std::string& state) const {
        const StateMachinePtr machine = slot->lock();
        return machine && machine->inState(state);
    }
};

struct Command {
    const char* name;
    bool (StateMachine::*function)();
    const char* doc;
};
struct Question {
    const char* name;
    bool (StateMachine::*function)() const;
    const char* doc;
};

const Command kCommands[] = {
    {"activate", &StateMachine::activate,
     "Enters the initial state, unless it is active or a precondition does not hold."},
    {"deactivate", &StateMachine::deactivate, "Leaves the present state, whatever it is, and becomes inactive."},
    {"start", &StateMachine::start,
     "Executes run programs and checks the transitions in each cycle; goes on after pause()."},
    {"automatic", &StateMachine::automatic, "The same as start()."},
    {"reactive", &StateMachine::reactive, "From now on, only events and requestState() change its state."},
    {"pause", &StateMachine::pause, "Pauses from the next cycle on."},
    {"step", &StateMachine::step,
     "If paused, executes one statement or transition; if reactive, checks the transitions once."},
    {"stop", &StateMachine::stop, "Goes to the final state."},
    {"reset", &StateMachine::reset, "Once stopped, goes to the initial state."},
};

const Question kQuestions[] = {
    {"inError", &StateMachine::inError, "Has a program or condition failed?"},
    {"isActive", &StateMachine::isActive, "Is it in any state?"},
    {"isRunning", &StateMachine::isRunning, "Does it check the transitions in each cycle?"},
    {"isReactive", &StateMachine::isReactive, "Do only events and requestState() change its state?"},
    {"isPaused", &StateMachine::isPaused, "Does it wait for start() or step()?"},
    {"inInitialState", &StateMachine::inInitialState, "Is it in its initial state?"},
    {"inFinalState", &StateMachine::inFinalState, "Is it in its final state?"},
    {"inTransition", &StateMachine::inTransition, "Is it on its way from one state to another?"},
};

}  // namespace

void addMachineOperations(Service& service, const MachineSlot& slot) {
    // C++ code may call all of them with the machine as first argument.
    for (const Command& command : kCommands) {
        service.addOperation(command.name, Call<bool>{slot, command.function}).doc(command.doc);
        service.addMemberOverloads<StateMachine>(command.name, command.function);
    }
    for (const Question& question : kQuestions) {
        service.addOperation(question.name, Query<bool>{slot, question.function}).doc(question.doc);
        service.addMemberOverloads<StateMachine>(question.name, question.function);
    }
    service.addOperation("requestState", CallWith<bool, const std::string&>{slot, &StateMachine::requestState})
        .doc("Goes to a state if a transition to it may be taken now, or if it is the final one.")
        .arg("StateName", "Where to go");
    service.addOperation("inState", InState{slot}).doc("Is it in this state?").arg("StateName", "The state");
    service.addOperation("getState", Query<std::string>{slot, &StateMachine::getCurrentStateName})
        .doc("The state it is in; empty if it is not active.");
    service.addOperation("trace", CallWith<void, bool>{slot, &StateMachine::trace})
        .doc("Logs what it does, at level Info.")
        .arg("Trace", "On or off");
    service.addMemberOverloads<StateMachine>("requestState", &StateMachine::requestState);
    service.addMemberOverloads<StateMachine>("inState", &StateMachine::inState);
    service.addMemberOverloads<StateMachine>("getState", &StateMachine::getCurrentStateName);
    service.addMemberOverloads<StateMachine>("trace", &StateMachine::trace);
}

void addMachineValues(Service& service, const Scope& scope) {
    for (const auto& named : scope.entries()) {
        const Scope::Entry& entry = named.second;
        if (!entry.source) continue;
        const types::TypeInfo& type = *entry.source->getTypeInfo();
        base::AttributeBase* const made = entry.constant ? type.buildConstant(named.first, entry.source)
                                                         : type.buildAttribute(named.first, entry.source);
        if (made) service.setValue(made);
    }
}

}  // namespace RTT::scripting::detail
