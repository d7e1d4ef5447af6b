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
 * step() (periodic) or loop() (not periodic), breakLoop() and finalize(). Any thread may call start() and stop(); of
 * several concurrent calls, exactly one takes effect.
 *
 * A class that overrides these must call stop() and terminate() in its own destructor.
 */
class RTT_API Thread : public ThreadInterface {
public:
    /**
     * Creates the thread; blocks until it exists. If the process may not use the scheduler or priority, they are
     * replaced with a warning (CheckScheduler, CheckPriority).
     * @param period seconds; 0 makes the thread non-periodic
     * @param cpuAffinity bit n allows CPU n; 0 allows all
     * @throw std::bad_alloc, with the reason in what(), if no thread can be created
     */
    Thread(int scheduler, int priority, Seconds period, unsigned cpuAffinity, const std::string& name);
    ~Thread() override;

    /**
     * Calls initialize() in the calling thread, then lets the thread run; false if initialize() returned false. If the
     * thread is active already, a non-periodic one executes loop() once more (true) and a periodic one refuses (false).
     */
    bool start() override;
    /**
     * Blocks until the thread has left loop() or step(), at most the stop timeout, then calls finalize() in the calling
     * thread. False if the thread is not active, if breakLoop() returned false, or if the time is over; in the last two
     * cases the thread stays active. If the thread itself calls it, it takes effect when the current loop() or step()
     * returns; a non-periodic thread asks breakLoop() first.
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
    /** The timeout that was set, or the default: 10 periods, or 1 second without a period (see setLockTimeout…()). */
    Seconds getStopTimeout() const override;

    /** Stack of threads that are created from now on, in bytes; 0 selects the default of the system. */
    static void setStackSize(unsigned bytes);
    /** Default stop timeout of non-periodic threads, in seconds. */
    static void setLockTimeoutNoPeriod(double seconds);
    /** Default stop timeout of periodic threads, in periods. */
    static void setLockTimeoutPeriodFactor(double periods);

protected:
    /** Creates a non-periodic thread for a sub-class that waits for its period itself; the log names that period, in
        seconds. */
    Thread(int scheduler, int priority, unsigned cpuAffinity, const std::string& name, Seconds nominalPeriod);

    virtual bool initialize();
    /** Called once per period in a periodic thread. */
    virtual void step();
    /** Called once per start() in a non-periodic thread. Default: step(). */
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
    /** The wake-up after `previous`, which came at `now`; counts overruns. 0 if there were too many and the thread was
        stopped. */
    nsecs nextWakeUp(nsecs previous, nsecs now, nsecs period);
    /** Marks the time in which stop() must call breakLoop(). */
    class UserCode {
    public:
        explicit UserCode(Thread& thread) noexcept;
        ~UserCode();
        UserCode(const UserCode&) = delete;
        UserCode& operator=(const UserCode&) = delete;

    private:
        Thread& thread_;
    };

    /** Stops at once and calls finalize(); called by the thread itself. */
    void emergencyStop();
    /** Ends the thread and waits for that; logs an error if it takes longer than the stop timeout. The object cannot be
        started any more. The thread itself must not call it, because it could not return to what it executes. */
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
