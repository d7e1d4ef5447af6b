// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_THREAD_HPP
#define ORO_OS_THREAD_HPP

#include <rtt/os/ThreadInterface.hpp>
#include <rtt/os/threads.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace RTT {
namespace os {

/**
 * A thread that is created idle with its object and can be started and stopped many times. Override initialize(),
 * step() (periodic) or loop() (not periodic), breakLoop() and finalize(). start() and stop() may be called from any
 * thread, at the same time as well: exactly one of several concurrent calls takes effect.
 *
 * A class that overrides these must call stop() and terminate() in its own destructor.
 */
class RTT_API Thread : public ThreadInterface {
public:
    /**
     * Creates the thread; blocks until it exists. Scheduler and priority are adjusted, with a warning, to what the
     * process may use (CheckScheduler, CheckPriority).
     * @param period seconds; 0 makes the thread non-periodic
     * @param cpuAffinity bit n allows CPU n; 0 allows all
     * @throw std::bad_alloc, with the reason in what(), if no thread can be created
     */
    Thread(int scheduler, int priority, Seconds period, unsigned cpuAffinity, const std::string& name);
    ~Thread() override;

    /**
     * Calls initialize() in the caller, then lets the thread run; false if that returned false. Active already: a
     * non-periodic thread executes loop() once more (true), a periodic one refuses (false).
     */
    bool start() override;
    /**
     * Blocks until the thread has left loop() or step(), at most the stop timeout, then calls finalize() in the
     * caller. False if not active, if breakLoop() returned false or if the time is over; the thread stays active then
     * in the last two cases. Called by the thread itself, it asks breakLoop(), too, if not periodic, and takes effect when the
     * current loop() or step() returns.
     */
    bool stop() override;
    bool isRunning() const override;
    bool isActive() const override;

    bool setPeriod(Seconds period) override;
    bool setPeriod(secs s, nsecs ns);
    bool setPeriod(TIME_SPEC period);
    Seconds getPeriod() const override;
    nsecs getPeriodNS() const override;

    const char* getName() const override;
    RTOS_TASK* getTask() override;
    const RTOS_TASK* getTask() const override;
    unsigned int getPid() const override;

    bool setScheduler(int scheduler) override;
    int getScheduler() const override;
    bool setPriority(int priority) override;
    int getPriority() const override;
    bool setCpuAffinity(unsigned cpuAffinity) override;
    unsigned getCpuAffinity() const override;

    void yield() override;
    /** Overruns after which a periodic thread is stopped; −1, the default, never stops it. */
    void setMaxOverrun(int maxOverrun) override;
    int getMaxOverrun() const override;
    void setWaitPeriodPolicy(int policy) override;
    void setStopTimeout(Seconds timeout) override;
    /** What was set, else 10 periods, else 1 second (see the two functions below). */
    Seconds getStopTimeout() const override;

    /** Stack of threads that are created from now on, in bytes; 0 selects the default of the system. */
    static void setStackSize(unsigned bytes);
    /** Default stop timeout of non-periodic threads, in seconds. */
    static void setLockTimeoutNoPeriod(double seconds);
    /** Default stop timeout of periodic threads, in periods. */
    static void setLockTimeoutPeriodFactor(double periods);

protected:
    /** Not periodic. For a sub-class that waits for its period itself: the log names that one, in seconds. */
    Thread(int scheduler, int priority, unsigned cpuAffinity, const std::string& name, Seconds nominalPeriod);

    virtual bool initialize();
    /** Periodic threads: called once per period. */
    virtual void step();
    /** Non-periodic threads: called once per start(). Default: step(). */
    virtual void loop();
    /** Asks a blocking loop() to return; true if it will. Called by stop(), in the stopping thread. */
    virtual bool breakLoop();
    virtual void finalize();

    /** Reasons to wake up. Values above kFirstOwnReason are for sub-classes. */
    enum : std::uint32_t { kStartReason = 1u, kStopReason = 2u, kExitReason = 4u, kFirstOwnReason = 8u };

    /** Everything the thread does between start() and stop(). */
    virtual void session();
    /** False as soon as the session must end. */
    bool mayRun() const noexcept;
    /** Wakes the thread with these reasons; costs one atomic operation if it is awake. Real-time safe. */
    void wake(std::uint32_t reasons) noexcept;
    /** Sleeps until woken or until the monotonic time; returns the reasons. Only for session(). */
    std::uint32_t waitForWake(nsecs deadline) noexcept;
    /** Reasons of sub-classes that arrived while no session was running. Only for session(). */
    std::uint32_t takeEarlyReasons() noexcept;
    /** The wake-up after `previous`, which came at `now`; counts overruns. 0: too many, the thread was stopped. */
    nsecs nextWakeUp(nsecs previous, nsecs now, nsecs period);
    /** Marks the time in which stop() must ask breakLoop(). */
    class UserCode {
    public:
        explicit UserCode(Thread& thread) noexcept;
        ~UserCode();
        UserCode(const UserCode&) = delete;
        UserCode& operator=(const UserCode&) = delete;

    private:
        Thread& thread_;
    };

    /** Stops at once, from the thread itself; calls finalize(). */
    void emergencyStop();
    /** Ends the thread and waits for its end, with an error in the log if that takes longer than the stop timeout. The object
        cannot be started any more. Not from the thread itself, which could not return to what it executes. */
    void terminate();

private:
    friend class UserCode;
    struct State;
    static void* entry(void* self);
    void run();
    void runOneSession();
    bool startAgain();
    bool stopSelf();
    bool goOn();
    bool mayBreakLoop();
    void finalizeToIdle();
    bool keepRunning();
    bool waitForSessionEnd(Seconds timeout) const;
    void waitForOthersStop() const;
    void reportIfBusy() const;

    std::unique_ptr<State> state_;
};

}  // namespace os
}  // namespace RTT
#endif
