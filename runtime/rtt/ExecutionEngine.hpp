// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXECUTION_ENGINE_HPP
#define ORO_EXECUTION_ENGINE_HPP

#include <rtt/base/DisposableInterface.hpp>
#include <rtt/base/ExecutableInterface.hpp>
#include <rtt/base/RunnableInterface.hpp>
#include <rtt/internal/EngineGate.hpp>
#include <rtt/internal/FunctionList.hpp>
#include <rtt/internal/Mailbox.hpp>

#include <boost/function.hpp>

#include <atomic>
#include <cstdint>
#include <vector>

namespace RTT {
namespace internal {
class SentCall;
}
namespace base {
class PortInterface;
class TaskCore;
}  // namespace base

/**
 * Executes what a component has to do, in the thread of its activity: sent operations, callbacks of event ports,
 * functions (scripts), hooks. One step for each call of work():
 *
 *   Trigger             messages and port callbacks, in order of arrival
 *   TimeOut, IOReady    the same, then functions, then updateHook() or errorHook()
 *
 * In Exception, programs and state machines stand still (ExecutableInterface::pausesInException()).
 *
 * A step takes at most Mailbox::kCapacity messages and callbacks; if they ask for more, another step follows.
 *
 * While a component waits for the operation of another one it executes messages, so that two components that call each
 * other do not wait for ever, and functions that others wait for (ExecutableInterface::isAwaited()); its port callbacks,
 * all other functions and hooks have to wait with it. A thread that is within the steps of several components (a master
 * and its slave) does so for all of them.
 *
 * What throws here puts the component into Exception. One queue of Mailbox::kCapacity entries takes everything that
 * other threads ask for; asking costs at most one wake-up of the component's thread, and none if it is awake. Nothing of
 * it is lost while the activity is stopped, started or exchanged.
 *
 * An engine may be destroyed while others send to it, also within its own step (by an operation, a port callback, a
 * function or updateHook(), which then return to nobody), but not while it waits.
 */
class RTT_API ExecutionEngine : public base::RunnableInterface {
public:
    /** `owner` is null for an engine that only executes messages. */
    explicit ExecutionEngine(base::TaskCore* owner = nullptr);
    /** Disposes of what is still queued. The activity must be stopped. */
    ~ExecutionEngine() override;

    /** Queues a message and wakes the activity. False, and the caller keeps the message, if it is null, the component is
        in FatalError, there is no activity or the queue is full. Any thread; real-time safe. */
    bool process(base::DisposableInterface* message) override;
    /** Queues the callback of a port. As above, but if the queue is full it is true nevertheless: the component looks
        through all its ports when it has executed what is queued. */
    bool process(base::PortInterface* port);
    /** The same; calls `queued()` if it is true and the component still exists (it may have been executed by this thread). */
    template <class Queued>
    bool process(base::PortInterface* port, Queued&& queued) {
        return process(port, internal::EngineGate::Visit(*gate_), queued);
    }
    /** The same in a visit that has begun. */
    template <class Queued>
    bool process(base::PortInterface* port, const internal::EngineGate::Visit& visit, Queued&& queued) {
        if (!enqueue({internal::Mailbox::Kind::Port, port}, visit.activity())) return false;
        if (visit.engine()) queued();
        return true;
    }
    /** Executes `function` in every step in which it is not idle, until its execute() returns false. False as
        above, and if it is loaded already. Any thread. */
    bool runFunction(base::ExecutableInterface* function);
    /** Stops executing it. Another thread than the engine's own waits for room in the queue, and until `function` is not being
        executed. True in the end. */
    bool removeFunction(base::ExecutableInterface* function);
    /** The same, for a function that removes itself in its execute(). */
    bool removeSelfFunction(base::ExecutableInterface* function) { return removeFunction(function); }

    /** Waits until `done()` is true. In the engine's own thread it executes messages meanwhile; blocks. */
    void waitForMessages(const boost::function<bool()>& done);
    /** The same, at most until the monotonic time in ns; returns done(). */
    bool waitForMessages(const boost::function<bool()>& done, std::int64_t deadline);
    /** For those who may outlive this engine. */
    const boost::intrusive_ptr<const internal::EngineGate>& gate() const { return gate_; }
    /** Queues a message for the engine of `gate`, if it still exists. As process(). */
    static bool process(const internal::EngineGate& gate, base::DisposableInterface* message);

    /** True in the thread that executes this engine. Real-time safe. */
    bool isSelf() const;
    /** True within work() of this engine, in the thread that executes it. Other than isSelf(), this is false in a thread
        that stands for the activity (SlaveActivity, SequentialActivity) and is doing something else. Real-time safe. */
    bool isStepping() const;
    /** The component; null for an engine without. */
    base::TaskCore* getTaskCore() const { return task_; }
    base::TaskCore* getParent() const { return task_; }

    /** For messages that threw in this engine: logs and puts the component into Exception. */
    void setExceptionTask();
    /** Called by the component in FatalError: stops the activity for good and disposes of what is queued. */
    void setFatalTask();
    /** Stops and starts the activity, so that no step is executing afterwards. False if it does not stop, or if this is called
        within a hook and breakUpdateHook() is false. */
    bool stopTask();
    /** Starts the activity and sees to it that it executes what was queued meanwhile. False after retire(). */
    bool startActivity();
    /** Other threads find no engine from now on and execute nothing of the component: what they sent or send is disposed of. For
        a thread that is about to destroy the component. Blocks until they have left; false if they have not at the monotonic
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
    class Removal;

    bool accepts() const;
    void enterException();
    bool enqueue(internal::Mailbox::Item item, base::ActivityInterface* activity);
    bool enqueue(internal::Mailbox::Item item);
    void disposeQueued();
    static bool processWaiting();
    bool waitForMessages(const boost::function<bool()>& done, std::int64_t deadline,
                         const internal::Presence::Word* also);
    bool processInStead(bool& again);
    bool waitInStead(const boost::function<bool()>& done, std::int64_t deadline);
    void triggerDeferred();
    void triggerSelf();
    static void dispose(internal::Mailbox::Item item);
    void takeAdditions();
    bool removeHere(base::ExecutableInterface* function, Removal* removal = nullptr);
    void awaitRemoval(Removal& removal, const internal::EngineGate& waiting);

    // These are given the step they belong to, because what they call may destroy this engine: they return then.
    void processMailbox(const Step& here, Depth depth);
    void execute(const Step& here, internal::Mailbox::Item item, Depth depth);
    void callDeferredPorts(const Step& here);
    void callMissedPorts(const Step& here);
    void callPort(const Step& here, base::PortInterface* port);
    void processFunctions(const Step& here);
    bool processAwaited(const Step& here);
    void unload(const internal::FunctionList::Round& round, base::ExecutableInterface& function);
    void processHooks(const Step& here);
    template <class Action>
    bool guarded(const Step& here, const char* what, Action&& action);
    void logException(const Step& here, const char* what, const char* why);
    template <class Hook>
    void callHook(const Step& here, const char* what, Hook&& hook);

    const boost::intrusive_ptr<const internal::EngineGate> gate_;
    base::TaskCore* task_;
    internal::Mailbox mailbox_;

    // Touched in the engine's thread only. Ports whose callbacks came up while the component was waiting:
    std::vector<base::PortInterface*> deferred_ports_;
    internal::FunctionList functions_;
    base::ExecutableInterface* executing_ = nullptr;
    bool in_hook_ = false;                   // updateHook() or errorHook() is being executed
    Removal* removals_ = nullptr;            // of executing_
    std::atomic<bool> break_asked_{false};   // by stopTask(), within a hook
    std::atomic<bool> deferred_{false};      // there are such ports
    std::atomic<bool> missed_ports_{false};  // there was no room for a port, here or in the mailbox
};

}  // namespace RTT

#endif
