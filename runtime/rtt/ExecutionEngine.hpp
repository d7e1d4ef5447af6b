// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXECUTION_ENGINE_HPP
#define ORO_EXECUTION_ENGINE_HPP

#include <rtt/base/DisposableInterface.hpp>
#include <rtt/base/ExecutableInterface.hpp>
#include <rtt/base/RunnableInterface.hpp>
#include <rtt/internal/engine/due_ports.hpp>
#include <rtt/internal/engine/engine_functions.hpp>
#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/internal/engine/mailbox.hpp>

#include <boost/function.hpp>

#include <atomic>
#include <cstdint>

namespace RTT {
namespace internal {
class SentCall;
}
namespace base {
class PortInterface;
class TaskCore;
}  // namespace base

/**
 * Executes the work of a component in the thread of its activity: sent operations, callbacks of event ports, functions
 * (scripts), hooks. Each call of work() is a step:
 *
 *   Trigger             messages and port callbacks, in order of arrival
 *   TimeOut, IOReady    the same, then functions, then updateHook() or errorHook()
 *
 * In Exception, programs and state machines pause (ExecutableInterface::pausesInException()).
 *
 * A step executes at most Mailbox::kCapacity messages and callbacks; if they queue more, another step follows.
 *
 * While a component waits for an operation of another one, it executes messages, so that two components that call each
 * other do not wait for ever, and functions that others wait for (ExecutableInterface::isAwaited()). Its port
 * callbacks, all other functions and hooks wait. A thread within the steps of several components (a master and its
 * slave) does so for all of them.
 *
 * An exception here puts the component into Exception. One queue of Mailbox::kCapacity entries takes all requests of
 * other threads. A request costs at most one wake-up of the component's thread, and none if it is awake. No request is
 * lost while the activity is stopped, started or exchanged.
 *
 * An engine may be destroyed while other threads send to it, also within its own step (by an operation, a port
 * callback, a function or updateHook()), but not while it waits.
 */
class RTT_API ExecutionEngine : public base::RunnableInterface {
public:
    /** `owner` is null for an engine that only executes messages. */
    explicit ExecutionEngine(base::TaskCore* owner = nullptr);
    /** Disposes of queued items. The activity must be stopped. */
    ~ExecutionEngine() override;

    /** Queues a message and wakes the activity. False, and the caller keeps the message, if that is null, the component
        is in FatalError, there is no activity or the queue is full. Any thread; real-time safe. */
    bool process(base::DisposableInterface* message) override;
    /** Queues the callback of a port. The same, but true even if the queue is full: the component then looks through
        all its ports after it has executed the queue. */
    bool process(base::PortInterface* port);
    /** The same; if true, calls `queued()` if the component still exists (this thread may have executed it). */
    template <class Queued>
    bool process(base::PortInterface* port, Queued&& queued) {
        return process(port, internal::EngineGate::Visit(*gate_), queued);
    }
    /** The same within a visit. */
    template <class Queued>
    bool process(base::PortInterface* port, const internal::EngineGate::Visit& visit, Queued&& queued) {
        if (!enqueue({internal::Mailbox::Kind::Port, port}, visit.activity())) return false;
        if (visit.engine()) queued();
        return true;
    }
    /** Executes `function` in every step in which it is not idle, until its execute() returns false. False as for
        process(), and if it is loaded already. Any thread. */
    bool runFunction(base::ExecutableInterface* function);
    /** Stops executing it. Other threads than the engine's wait for room in the queue, and until `function` is not
        being executed. Always true. */
    bool removeFunction(base::ExecutableInterface* function);
    /** The same, for a function that removes itself in its execute(). */
    bool removeSelfFunction(base::ExecutableInterface* function) { return removeFunction(function); }

    /** Waits until `done()` is true. In the engine's own thread it executes messages meanwhile; blocks. */
    void waitForMessages(const boost::function<bool()>& done);
    /** The same, at most until the monotonic time `deadline` in ns; returns done(). */
    bool waitForMessages(const boost::function<bool()>& done, std::int64_t deadline);
    /** For users that may outlive this engine. */
    const boost::intrusive_ptr<const internal::EngineGate>& gate() const { return gate_; }
    /** Queues a message for the engine of `gate`, if that still exists, like process(). */
    static bool process(const internal::EngineGate& gate, base::DisposableInterface* message);

    /** True in the thread that executes this engine. Real-time safe. */
    bool isSelf() const;
    /** True within work() of this engine, in the thread that executes it. Unlike isSelf(), it is false in a thread that
        acts as the activity (SlaveActivity, SequentialActivity) outside a step. Real-time safe. */
    bool isStepping() const;
    /** The component; null for an engine without one. */
    base::TaskCore* getTaskCore() const { return task_; }
    base::TaskCore* getParent() const { return task_; }

    /** For messages that threw in this engine: logs that and puts the component into Exception. */
    void setExceptionTask();
    /** Called by the component in FatalError: stops the activity for good and disposes of queued items. */
    void setFatalTask();
    /** Stops and starts the activity, so that no step is executing afterwards. False if it does not stop, or within a
        hook if breakUpdateHook() is false. */
    bool stopTask();
    /** Starts the activity and has it execute items that were queued meanwhile. False after retire(). */
    bool startActivity();
    /** For a thread that is about to destroy the component: other threads find no engine from now on and execute
        nothing of the component; their messages are disposed of. Blocks until they have left; false at the monotonic
        time `deadline` (ns). */
    bool retire(std::int64_t deadline = INT64_MAX);

    base::ActivityInterface* getActivity() const override { return gate_->activity(); }
    /** Called by the activity; blocks until no other thread uses the previous one. */
    void setActivity(base::ActivityInterface* activity) override;
    bool initialize() override;
    void step() override;
    void loop() override;
    bool breakLoop() override;
    void finalize() override;
    void work(WorkReason reason) override;
    bool hasWork() override;

private:
    friend class internal::EngineGate;
    friend class internal::SentCall;
    enum class Depth { Step, Waiting };
    typedef internal::EngineGate::Step Step;

    bool accepts() const;
    void enterException();
    bool waitForMessages(const boost::function<bool()>& done, std::int64_t deadline,
                         const internal::Presence::Word* also);
    bool enqueue(internal::Mailbox::Item item, base::ActivityInterface* activity);
    bool enqueue(internal::Mailbox::Item item);
    void disposeQueued();
    static bool processWaiting();
    bool processInStead(bool& again);
    bool waitInStead(const boost::function<bool()>& done, std::int64_t deadline);
    void triggerDeferred();
    void triggerSelf();
    static void dispose(internal::Mailbox::Item item);
    void takeAdditions();
    bool removeHere(base::ExecutableInterface* function, internal::FunctionRemoval* removal = nullptr);
    void awaitRemoval(internal::FunctionRemoval& removal, const internal::EngineGate& waiting);

    // These take their step, because the code that they call may destroy this engine; they then return.
    void processMailbox(const Step& here, Depth depth);
    void execute(const Step& here, internal::Mailbox::Item item, Depth depth);
    void callDeferredPorts(const Step& here);
    bool callPort(const Step& here, base::PortInterface* port);
    void processHooks(const Step& here);
    template <class Hook>
    void callHook(const Step& here, const char* what, Hook&& hook);

    const boost::intrusive_ptr<const internal::EngineGate> gate_;
    base::TaskCore* task_;
    internal::Mailbox mailbox_;

    internal::DuePorts ports_;
    internal::EngineFunctions functions_;
    bool in_hook_ = false;                  // updateHook() or errorHook() is being executed
    std::atomic<bool> break_asked_{false};  // by stopTask(), within a hook
};

}  // namespace RTT

#endif
