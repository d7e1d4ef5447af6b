// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The executable form of a state machine: states and transitions with their programs and conditions.
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_MODEL_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_MODEL_HPP

#include <rtt/Service.hpp>
#include <rtt/scripting/StateMachine.hpp>
#include <rtt/scripting/detail/syntax/ast.hpp>
#include <rtt/scripting/detail/execute/process.hpp>
#include <rtt/scripting/detail/compile/source_file.hpp>

#include <diag/diagnostic.hpp>

#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace RTT::scripting::detail {

/** A program of a state or transition, or the initial values of variables. Real-time safe, except failure() and
    where(), and what the script itself calls. */
class Routine {
public:
    typedef Process::Outcome Outcome;
    virtual ~Routine();
    virtual void restart() = 0;
    virtual Outcome run() = 0;
    virtual Outcome runStatement() = 0;
    /** True between its beginning and its end. */
    virtual bool started() const = 0;
    /** The line of the statement that is next, or that failed; at the beginning that of the first one. */
    virtual unsigned line() const = 0;
    virtual oroforge::diag::Location where() const = 0;
    virtual std::string failure() const = 0;
};
typedef std::unique_ptr<Routine> RoutinePtr;

/** A condition of a transition, a precondition, or new data on a port. */
class Guard {
public:
    enum class Truth { No, Yes, Failed };
    virtual ~Guard();
    /** `round` changes each time the machine checks its transitions; a port is read once in a round. */
    virtual Truth check(unsigned round) = 0;
    virtual oroforge::diag::Location where() const = 0;
    virtual std::string failure() const = 0;
};
typedef std::unique_ptr<Guard> GuardPtr;

class EventQueue;
struct MachineState;

/** The target of a transition: the first of `states` whose preconditions hold. Without states, the machine stays. */
struct MachineSelection {
    std::vector<MachineState*> states;
    RoutinePtr program;  ///< or null
};

struct MachineTransition {
    ast::Place at;
    GuardPtr event;      ///< new data on a port; or null
    GuardPtr condition;  ///< or null
    MachineSelection then;
    std::unique_ptr<MachineSelection> otherwise;  ///< or null
};

/** A transition that a call of an operation causes. */
class MachineEvent {
public:
    virtual ~MachineEvent();
    /** Assigns the arguments of the call to the variables of the script. */
    virtual void receive() = 0;

    MachineTransition transition;
    const MachineState* state = nullptr;  ///< null for any state
};

struct MachineState final : StateInterface {
    const std::string& getName() const override { return name; }

    std::string name;
    RoutinePtr locals;  ///< assigns its variables when it is entered
    RoutinePtr entry, run, handle, exit;
    std::vector<GuardPtr> preconditions;  ///< must hold when a transition leads here
    /** Checked after the exit of the previous state: the first one that may be taken leads to another state instead. */
    std::vector<MachineTransition> detours;
    std::vector<MachineTransition> transitions;
};

struct MachineModel {
    std::string name;  ///< with the names of its outer machines
    std::string text;
    unsigned firstLine = 1;           ///< the first line of the text in its file
    std::vector<RoutinePtr> initial;  ///< parameters and variables, in this order
    std::deque<MachineState> states;
    std::vector<MachineTransition> transitions;  ///< from any state
    MachineState* first = nullptr;
    MachineState* last = nullptr;
    std::vector<StateMachinePtr> children;
    std::vector<std::unique_ptr<MachineEvent>> events;
    std::shared_ptr<EventQueue> queue;  ///< for the events; null if there are none
    Service::shared_ptr service;
    SourceFilePtr source;  ///< the file of the type; or null
};

}  // namespace RTT::scripting::detail

#endif
