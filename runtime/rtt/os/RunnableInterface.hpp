// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_RUNNABLE_INTERFACE_HPP
#define ORO_OS_RUNNABLE_INTERFACE_HPP

#include <rtt/rtt-config.h>

/**
 * @file
 * Defines base::RunnableInterface. It is in this folder because os::Timer derives from it and this layer includes
 * nothing above itself. Include <rtt/base/RunnableInterface.hpp> instead.
 */
namespace RTT {
namespace os {
class ThreadInterface;
}
namespace base {
class ActivityInterface;
class DisposableInterface;

/**
 * Something an activity executes. Periodic activities call step() and work(TimeOut) once per period; others call
 * loop() and work(Trigger) when triggered, and step() and work(TimeOut) after timeout(). All of them run in the thread
 * of the activity, except initialize() (in the thread that starts), finalize() and breakLoop() (in the one that stops).
 */
class RTT_API RunnableInterface {
public:
    /** Why work() is called. */
    enum WorkReason { TimeOut = 0, Trigger, IOReady };

    RunnableInterface();
    /** Detaches from the activity, which must have been stopped. */
    virtual ~RunnableInterface();
    RunnableInterface(const RunnableInterface&) = delete;
    RunnableInterface& operator=(const RunnableInterface&) = delete;

    /** Called by start(); false makes start() fail. */
    virtual bool initialize() = 0;
    virtual void step() = 0;
    virtual void finalize() = 0;

    virtual void work(WorkReason reason);
    /** Default: step(). */
    virtual void loop();
    /** Asks a blocking loop() or work() to return; true if it will. */
    virtual bool breakLoop();
    /** True if there are messages to execute. Must be safe to call from any thread. */
    virtual bool hasWork();
    /**
     * Queues a message for execution in the thread of this runnable. If it accepts none, returns false and the caller
     * keeps the message. The ExecutionEngine implements it; SlaveActivity uses it on its master. May be called from any
     * thread.
     */
    virtual bool process(DisposableInterface* message);

    /** The thread of the activity, null if there is none. */
    virtual os::ThreadInterface* getThread() const;
    virtual ActivityInterface* getActivity() const;
    /** Called by the activity to attach; null detaches. */
    virtual void setActivity(ActivityInterface* activity);

protected:
    ActivityInterface* owner_task = nullptr;
};

}  // namespace base
}  // namespace RTT
#endif
