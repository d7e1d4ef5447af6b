// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_BASE_ACTIVITY_INTERFACE_HPP
#define ORO_BASE_ACTIVITY_INTERFACE_HPP

#include <rtt/Time.hpp>
#include <rtt/base/RunnableInterface.hpp>
#include <rtt/os/ThreadInterface.hpp>

#include <boost/shared_ptr.hpp>

#include <memory>

namespace RTT {
namespace internal {
class AccessGate;
}
namespace base {

/** Executes a RunnableInterface: decides in which thread, when and how often. */
class RTT_API ActivityInterface {
public:
    typedef boost::shared_ptr<ActivityInterface> shared_ptr;

    ActivityInterface();
    /** Attaches `runner`; if another activity has it, that one keeps it until start() or run(). See adopt(). */
    explicit ActivityInterface(RunnableInterface* runner);
    /** Detaches the runner. Subclasses call closeGate() and stop the activity in their own destructors. */
    virtual ~ActivityInterface();
    ActivityInterface(const ActivityInterface&) = delete;
    ActivityInterface& operator=(const ActivityInterface&) = delete;

    /** Replaces the runnable, which may be null or belong to another activity that is not active. False while this
        activity is active. */
    virtual bool run(RunnableInterface* runner);
    /** The runnable that it executes, or will execute from start() on if another activity has it now. */
    RunnableInterface* getRunner() const { return runner; }

    virtual bool start() = 0;
    virtual bool stop() = 0;
    /** True if it is executing or, if periodic, scheduled for execution. */
    virtual bool isRunning() const = 0;
    /** True if it was started and not stopped. */
    virtual bool isActive() const = 0;

    /** Seconds; 0 if not periodic. */
    virtual Seconds getPeriod() const = 0;
    /** In seconds; false if this activity cannot have that period. */
    virtual bool setPeriod(Seconds period) = 0;
    virtual bool isPeriodic() const;
    virtual unsigned getCpuAffinity() const = 0;
    virtual bool setCpuAffinity(unsigned cpuAffinity) = 0;

    /** Runs one cycle in the calling thread; false if this kind of activity has a thread that does it. */
    virtual bool execute() = 0;
    /** Requests execution because of a message or an event. Real-time safe. False if that is impossible. */
    virtual bool trigger() = 0;
    /** Requests execution as if the period were over. Real-time safe. False if that is impossible. */
    virtual bool timeout() = 0;
    /** The thread that executes, or the one that acts as it. */
    virtual os::ThreadInterface* thread() = 0;

    /**
     * True if the caller is, at this moment, the one thread that may touch the runner: its own or, for an activity that
     * borrows threads, the one that is executing it. Real-time safe. Use it instead of thread()->isSelf().
     */
    virtual bool isSelf() const;

    /** Whether this thread may touch the runner, see beginDirect(). */
    enum class Direct { Refused, Granted, Entered };
    /**
     * For a call of this thread on the component without a message, because isSelf(). Granted: it may call. Entered: it
     * may call, no other thread executes the runner meanwhile, and it calls endDirect() afterwards. Real-time safe:
     * waits for no execution, and at most some microseconds for another thread that asks at the same moment.
     */
    virtual Direct beginDirect();
    /**
     * The same for any thread while no thread executes the runner or is known to do so soon: for a sequential activity
     * or a slave between two executions, or a simulation without steps. Otherwise like beginDirect().
     */
    virtual Direct beginInStead();
    virtual void endDirect();

    /** For users of an activity that others may destroy, such as a slave: take a Pass before each use. */
    const std::shared_ptr<internal::AccessGate>& gate() const;

protected:
    /**
     * The last statement of a constructor: attaches `newRunner`, which may trigger this activity from then on. If
     * another activity has it, that one continues to execute it and this one only remembers it for claimRunner().
     */
    void adopt(RunnableInterface* newRunner);
    /**
     * For start(), before initialize(): takes the runner from the activity that has it, after stopping that one. Also
     * true if it is attached already or there is none. False, with an error logged, if the other activity does not
     * stop, or if this thread is executing it. Two activities of one runnable must not be started at the same time.
     */
    bool claimRunner();
    /** Attaches even if the activity is active. Waits for threads that have passed the gate. */
    void attach(RunnableInterface* newRunner);
    /**
     * Lets no further thread pass the gate and waits for those that have. The first statement of a destructor, because
     * this object is incomplete afterwards. Later calls do nothing.
     */
    void closeGate() noexcept;
    RunnableInterface* runner = nullptr;

private:
    bool isWithin();

    std::shared_ptr<internal::AccessGate> gate_;
    bool attached_ = false;  // the runner knows this activity
    bool gateClosed_ = false;
};

}  // namespace base
}  // namespace RTT
#endif
