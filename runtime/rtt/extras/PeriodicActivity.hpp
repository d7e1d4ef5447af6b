// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_PERIODIC_ACTIVITY_HPP
#define ORO_EXTRAS_PERIODIC_ACTIVITY_HPP

#include <rtt/base/ActivityInterface.hpp>
#include <rtt/extras/TimerThread.hpp>

#include <atomic>

namespace RTT {
namespace extras {

/**
 * A periodic activity that shares its thread with every other PeriodicActivity of the same scheduler, priority, period
 * and CPU affinity: step() and work(TimeOut) of each run in turn, once per period. It cannot be triggered, so
 * operations that run in its thread are executed at the next period.
 */
class RTT_API PeriodicActivity : public base::ActivityInterface {
public:
    /** ORO_SCHED_RT; period in seconds. */
    PeriodicActivity(int priority, Seconds period, base::RunnableInterface* runner = nullptr);
    PeriodicActivity(int scheduler, int priority, Seconds period, base::RunnableInterface* runner = nullptr);
    PeriodicActivity(int scheduler, int priority, Seconds period, unsigned cpuAffinity,
                     base::RunnableInterface* runner = nullptr);
    explicit PeriodicActivity(TimerThreadPtr thread, base::RunnableInterface* runner = nullptr);
    /** Sets the period of the thread. */
    PeriodicActivity(Seconds period, TimerThreadPtr thread, base::RunnableInterface* runner = nullptr);
    PeriodicActivity(secs s, nsecs ns, TimerThreadPtr thread, base::RunnableInterface* runner = nullptr);
    ~PeriodicActivity() override;

    /** False if active, if initialize() returned false or if the thread has too many activities. */
    bool start() override;
    /**
     * Waits for an execution in another thread to end, at most ten periods or one second, whichever is longer. If it
     * does not end, logs an error, returns false and stays active.
     */
    bool stop() override;
    bool isRunning() const override;
    bool isActive() const override;
    Seconds getPeriod() const override;
    /** Always false: the thread is shared. */
    bool setPeriod(Seconds) override { return false; }
    unsigned getCpuAffinity() const override;
    bool setCpuAffinity(unsigned cpuAffinity) override;
    bool execute() override { return false; }
    bool trigger() override { return false; }
    bool timeout() override { return false; }
    os::ThreadInterface* thread() override;
    bool isSelf() const override;
    /** After a thread entered, the timer thread waits for it, at most one second, and otherwise skips this activity. */
    Direct beginDirect() override;
    /** Refused while the thread is active. */
    Direct beginInStead() override;
    void endDirect() override;

protected:
    virtual bool initialize();
    virtual void step();
    virtual void work(base::RunnableInterface::WorkReason reason);
    virtual void finalize();
    TimerThread& timerThread() const { return *thread_; }
    /** True if a thread is executing it. */
    bool isExecuted() const { return executor_ != 0; }

private:
    friend class TimerThread;
    void executePeriod();

    TimerThreadPtr thread_;
    std::atomic<bool> running_{false};
    std::atomic<bool> active_{false};
    std::atomic<bool> changing_{false};  // within start() or stop()
    std::atomic<int> executor_{0};       // Linux id of the executing thread; see TimerThread::enterNow()
};

}  // namespace extras
}  // namespace RTT
#endif
