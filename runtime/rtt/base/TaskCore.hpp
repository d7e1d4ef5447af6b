// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TASK_CORE_HPP
#define ORO_TASK_CORE_HPP

#include <rtt/Time.hpp>
#include <rtt/rtt-config.h>

#include <atomic>
#include <cstdint>
#include <string>

namespace RTT {
class ExecutionEngine;
namespace base {
class ActivityInterface;
class PortInterface;

/**
 * The life cycle of a component:
 *
 *   PreOperational --configure()--> Stopped --start()--> Running --error()--> RunTimeError
 *          ^------cleanup()-----------|^------stop()-------|^-----recover()--------'
 *   any state --exception()--> Exception --recover()--> the state it was constructed with
 *   any state --fatal()--> FatalError, for good
 *
 * The functions that change the state call the hooks in the thread of the caller; updateHook() and errorHook() run in
 * the component's thread. Any thread may call them. While one of configure(), start(), stop() and cleanup() is in
 * progress, they return false in other threads. error(), exception() and fatal() may come in between; the change in
 * progress then returns false. The functions are as real-time safe as the hooks; they block as long as the hooks do,
 * stop() and fatal() also until the current step is over.
 */
class RTT_API TaskCore {
public:
    /** In this order: from Stopped on a component is configured, from Running on it is running. */
    enum TaskState { Init, PreOperational, FatalError, Exception, Stopped, Running, RunTimeError };

    explicit TaskCore(TaskState initial_state = Stopped, const std::string& name = "");
    virtual ~TaskCore();
    TaskCore(const TaskCore&) = delete;
    TaskCore& operator=(const TaskCore&) = delete;

    virtual const std::string& getName() const;

    /** From PreOperational, or from Stopped to configure again. */
    virtual bool configure();
    /** From Stopped. */
    virtual bool start();
    /** From Running or RunTimeError. False, and the component continues, if the activity cannot be stopped. */
    virtual bool stop();
    /** From Stopped. */
    virtual bool cleanup();
    /** Starts the activity; does not change the state. */
    virtual bool activate();
    /** From Exception to the initial state, from RunTimeError to Running. Calls no hook. False while stop() is in
        progress. */
    virtual bool recover();
    /** The name of recover() before 2.0. */
    bool resetException() { return recover(); }
    /** While running: errorHook() replaces updateHook(). */
    virtual void error();

    /** Executes one step in this thread, for activities without a thread of their own (SlaveActivity). */
    virtual bool update();
    /** Requests an execution of updateHook(), if the activity is not periodic. Real-time safe. */
    virtual bool trigger();

    virtual bool isConfigured() const;
    virtual bool isRunning() const;
    virtual bool isActive() const;
    virtual bool inFatalError() const;
    virtual bool inException() const;
    virtual bool inRunTimeError() const;
    virtual TaskState getTaskState() const;
    /** The target of the change of state in progress. */
    virtual TaskState getTargetState() const;

    /** Seconds; 0 if not periodic, -1 without an activity. */
    virtual Seconds getPeriod() const;
    virtual bool setPeriod(Seconds period);
    virtual unsigned getCpuAffinity() const;
    virtual bool setCpuAffinity(unsigned cpu);

    ExecutionEngine* engine() const { return ee; }

protected:
    /** Prepares the component; with false it stays PreOperational. Default: true. */
    virtual bool configureHook();
    /** Last preparations; with false it stays Stopped. Default: true. */
    virtual bool startHook();
    /** One cycle. Default: nothing. */
    virtual void updateHook();
    /** Called by stop() when updateHook() or errorHook() itself calls that and, in an Activity without period, when
        another thread calls it during a step. Make the hook return, or return false to continue. Default: true. */
    virtual bool breakUpdateHook();
    /** One cycle in state RunTimeError. Default: nothing. */
    virtual void errorHook();
    /** Undoes startHook(). */
    virtual void stopHook();
    /** Undoes configureHook(). */
    virtual void cleanupHook();
    /** Called in state Exception, after stopHook() and cleanupHook() if they were due. */
    virtual void exceptionHook();

    /** Leaves the current state: calls stopHook() if it was running, cleanupHook() if it was configured and was
        constructed PreOperational, then exceptionHook(). Skips the hook that is being called now. A hook that throws
        here leads to FatalError. */
    virtual void exception();
    /** Stops everything for good. */
    virtual void fatal();

    /** Called by the engine with a port that has new data. */
    virtual void dataOnPortCallback(PortInterface* port);

    /** The engine calls it with a port that has new data, or with null for all ports that did not fit into the queue.
        Not a virtual function, because the component may be under destruction. Set by TaskContext. */
    typedef void (*PortStep)(TaskCore& task, PortInterface* port);
    PortStep port_step_ = nullptr;

    /** The result of getTaskState() or getTargetState(), for subclasses that read it as a variable. Assigning it
        changes only the state: no hook is called. */
    class RTT_API StateVariable {
    public:
        StateVariable(TaskCore& task, bool target) : task_(task), target_(target) {}
        StateVariable(const StateVariable&) = delete;
        StateVariable& operator=(const StateVariable& other) { return *this = TaskState(other); }
        StateVariable& operator=(TaskState state);
        operator TaskState() const { return target_ ? task_.getTargetState() : task_.getTaskState(); }

    private:
        TaskCore& task_;
        const bool target_;
    };

    friend class RTT::ExecutionEngine;
    ExecutionEngine* ee;
    StateVariable mTaskState{*this, false}, mTargetState{*this, true};
    const TaskState mInitialState;
    /** How often it was started; incremented before it is Running. */
    std::atomic<unsigned> mStartCounter{0};
    bool mTriggerOnStart = true;
    unsigned mCycleCounter = 0, mIOCounter = 0, mTimeOutCounter = 0, mTriggerCounter = 0;

private:
    enum class Outcome { Accepted, Refused, Threw };
    /** State, target and the thread (its Linux id) that is changing the state, which is 0 for none. */
    struct States {
        TaskState state, target;
        int changer;
    };
    class Change;
    static std::uint64_t pack(const States& states);
    States states() const;
    template <class Modify>
    bool modify(Modify&& modify);
    void aim(TaskState to);
    template <class Hook>
    Outcome callHook(const char* function, TaskState during, Hook hook);

    std::atomic<std::uint64_t> states_;  // packed, so that a change is one atomic operation
    std::string name_;
    // stopHook() or cleanupHook() is being called by stop() or cleanup().
    std::atomic<bool> stopped_{false}, cleaned_up_{false};
};

}  // namespace base
}  // namespace RTT

#endif
