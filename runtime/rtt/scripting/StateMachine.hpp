// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_STATE_MACHINE_HPP
#define ORO_STATE_MACHINE_HPP

#include <rtt/base/ExecutableInterface.hpp>
#include <rtt/scripting/rtt-scripting-fwd.hpp>

#include <boost/enable_shared_from_this.hpp>

#include <memory>
#include <string>
#include <vector>

namespace RTT {
class Service;

namespace scripting {

namespace detail {
class EventQueue;
class MachineCore;
class OperationEvent;
struct MachineModel;
}  // namespace detail

/** A state of a machine. It lives as long as the machine. */
class RTT_API StateInterface {
public:
    virtual ~StateInterface();
    /** Real-time safe; any thread. */
    virtual const std::string& getName() const = 0;
};

/**
 * A state machine that a script defined and a component's engine executes: execute() is one cycle. Each machine, sub
 * machines too, is a function of its own in the engine; until it is loaded there, its status is `unloaded` and commands
 * return false.
 *
 *     command          accepted when                 does
 *     activate()       inactive                      assigns parameters and variables, enters the initial state; false
 *                                                    if one of its preconditions does not hold or an initial value
 *                                                    fails. True even if its entry failed, which leaves the machine in
 *                                                    error. `run` waits for start()
 *     automatic()      not inactive, error           running: executes `run` and checks the transitions in each cycle.
 *       = start()                                    Starts `run` from its beginning; continues after pause()
 *     reactive()       not inactive, error           active: only events and requestState() change the state
 *     pause()          not inactive, deactivating    paused, from the next cycle on; while it is stopping, when it has
 *                                                    stopped
 *     step()           paused, or after pause()      one statement, or one transition, in the next cycle
 *                      active                        checks all transitions once, in the next cycle
 *     stop()           not inactive, deactivating    goes to the final state from the next cycle on; then stopped.
 *                                                    Cancels a pause() or step() that has not taken effect
 *     reset()          stopped                       enters the initial state, as activate() does; then active
 *     deactivate()     not inactive                  executes the exit program of the state; then inactive
 *     requestState(S)  no transition or `handle` is  if S is the present state: executes `handle` and `run`. Otherwise
 *                      being executed                goes to S by the first transition that leads there and may be
 *                                                    taken; to the final state, and from there to the initial one,
 *                                                    also without one. Exit and entry are executed at once, unless a
 *                                                    program of the machine itself calls it, or the machine is paused
 *
 * Programs that `yield` continue in the next cycle; meanwhile the status is activating, stopping, resetting or
 * deactivating.
 *
 * Any thread, and the programs of the machine itself, may call all functions. Commands execute what they can at once in
 * the calling thread; the engine skips cycles during that time. Unless stated otherwise, they wait while the engine is
 * within a cycle, executing messages of the calling thread's component; after five seconds they log an error and return
 * false. pause(), step() and stop() never wait and are real-time safe. execute() and the commands are as real-time safe
 * as what the script calls. Queries are real-time safe, unless they return a copy of a text.
 */
class RTT_API StateMachine : public base::ExecutableInterface, public boost::enable_shared_from_this<StateMachine> {
public:
    struct Status {
        enum StateMachineStatus {
            inactive,
            activating,
            active,
            requesting,
            running,
            stopping,
            stopped,
            resetting,
            deactivating,
            paused,
            error,
            unloaded
        };
    };
    typedef Status::StateMachineStatus StateMachineStatus;
    typedef std::vector<StateMachinePtr> ChildList;

    /** For the reader of scripts. */
    explicit StateMachine(std::unique_ptr<detail::MachineModel> model);
    /** The engine must not have it any more. */
    ~StateMachine() override;

    bool activate();
    bool automatic();
    bool start() { return automatic(); }
    bool reactive();
    bool pause();
    bool step();
    bool stop();
    bool reset();
    bool deactivate();
    bool requestState(const std::string& state);
    /** Tells in the log, at level Info, what it does. */
    void trace(bool on);

    /** "root", "root.sub". */
    const std::string& getName() const;
    /** Of the type, as in the script. */
    const std::string& getText() const;
    /** The line of its file that this text begins in, by which getLineNumber() counts. */
    int getFirstLine() const;
    /** Of the statement that comes next or failed, or the transition looked at last; 0 if inactive. */
    int getLineNumber() const;
    StateMachineStatus getStatus() const;
    std::string getStatusStr() const;
    /** Empty if not active. */
    std::string getCurrentStateName() const;
    std::vector<std::string> getStateList() const;
    /** The state it is in; null if it is not active. */
    StateInterface* currentState() const;
    StateInterface* getInitialState() const;
    StateInterface* getFinalState() const;
    /** The state of that name; null if there is none. */
    StateInterface* getState(const std::string& name) const;
    bool inState(const std::string& state) const;
    bool inInitialState() const;
    bool inFinalState() const;
    /** True if a transition program, an exit or an entry is being executed or is next. */
    bool inTransition() const;
    /** True if it is in a state. */
    bool isActive() const;
    bool isRunning() const { return getStatus() == Status::running; }
    /** True if only events and requests change the state. */
    bool isReactive() const;
    bool isPaused() const { return getStatus() == Status::paused; }
    bool isStopped() const { return getStatus() == Status::stopped; }
    bool inError() const { return getStatus() == Status::error; }
    /** Why it is in error, with the place; empty if it is not. */
    std::string getError() const;

    const ChildList& getChildren() const;
    /** The service with its operations, parameters and variables and with the services of its sub machines; null if it
        has none. */
    boost::shared_ptr<Service> getService() const;

    /** Executes one cycle. Always true. */
    bool execute() override;
    /** True if it is inactive, stopped, paused or in error, and no request is pending. */
    bool isIdle() const override;
    bool pausesInException() const override { return true; }
    /**
     * Stops and deactivates the machine and its sub machines by executing them in this thread, each for at most a
     * second, while the engine skips them. If one does not end, logs that and returns false; it goes on stopping in
     * later cycles. If a program of the machine calls this, does nothing and returns false.
     */
    bool bringDown();

    /** Keeps the machine until an execute() in progress has returned, because one of its own programs may unload it.
        Call it in the engine's thread, or when the engine does not execute the machine any more. */
    void outliveExecution();

private:
    class Execution;
    friend class detail::EventQueue;
    /** Handles a call; false if another thread has the machine, and the call must wait. */
    bool react(detail::OperationEvent& event, void* const* arguments);
    /** Takes the waiting events, unless another thread has the machine. */
    void takeEvents();
    template <class Command>
    bool command(const char* name, Command command);
    bool request(bool (detail::MachineCore::*what)());
    /** Makes the engine execute a cycle soon. */
    void askForCycle();

    const std::unique_ptr<Execution> execution_;
};

}  // namespace scripting
}  // namespace RTT

#endif
