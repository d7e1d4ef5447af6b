// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ACTIVITY_HPP
#define ORO_ACTIVITY_HPP

#include <rtt/base/ActivityInterface.hpp>
#include <rtt/os/Thread.hpp>

#include <atomic>
#include <string>

namespace RTT {

/**
 * An activity with a thread of its own, periodic or not. setPeriod() switches between the two at any time.
 *
 * Not periodic: start(), trigger() and start() again execute loop() and work(Trigger) once, timeout() executes step()
 * and work(TimeOut). Wake-ups that arrive while it executes are remembered, one of each kind.
 *
 * Periodic: start() executes work(Trigger) at once; step() and work(TimeOut) follow one period later and then once
 * per period; trigger() executes step() and work(Trigger) in between without moving the periods. If a trigger and the
 * end of a period coincide, the work of the period serves both.
 *
 * trigger() and timeout() are real-time safe: one atomic operation, and one system call only if the thread sleeps.
 */
class RTT_API Activity : public base::ActivityInterface, public os::Thread {
public:
    /** The parameters of a new activity, by name. */
    struct Options {
        std::string name = "Activity";
        int scheduler = ORO_SCHED_OTHER;
        int priority = 1;         /**< os::LowestPriority */
        Seconds period = 0.0;     /**< 0: not periodic */
        unsigned cpuAffinity = 0; /**< bit n allows CPU n, 0 allows all */
        int waitPolicy = ORO_WAIT_ABS;
        int maxOverrun = -1;       /**< −1: overruns never stop it */
        Seconds stopTimeout = 0.0; /**< 0: the default, see getStopTimeout() */
    };
    explicit Activity(const Options& options, base::RunnableInterface* r = nullptr);

    /** Not periodic, ORO_SCHED_OTHER. */
    explicit Activity(base::RunnableInterface* r = nullptr, const std::string& name = "Activity");
    /** Not periodic, ORO_SCHED_RT. */
    explicit Activity(int priority, base::RunnableInterface* r = nullptr, const std::string& name = "Activity");
    /** ORO_SCHED_RT with a period in seconds. */
    Activity(int priority, Seconds period, base::RunnableInterface* r = nullptr, const std::string& name = "Activity");
    Activity(int scheduler, int priority, base::RunnableInterface* r = nullptr, const std::string& name = "Activity");
    Activity(int scheduler, int priority, Seconds period, base::RunnableInterface* r = nullptr,
             const std::string& name = "Activity");
    /** cpuAffinity: bit n allows CPU n, 0 allows all. */
    Activity(int scheduler, int priority, Seconds period, unsigned cpuAffinity, base::RunnableInterface* r = nullptr,
             const std::string& name = "Activity");
    /** Stops and ends the thread; blocks until it has ended. */
    ~Activity() override;

    bool run(base::RunnableInterface* r) override;
    /** Calls initialize() in the caller. See os::Thread::start(). Takes the runner from another activity that has it,
        and stops that one; false if it does not stop. */
    bool start() override;
    /** Calls finalize() in the caller once the thread is idle. See os::Thread::stop(). */
    bool stop() override;
    bool isRunning() const override;
    bool isActive() const override;
    bool isPeriodic() const override;
    Seconds getPeriod() const override;
    nsecs getPeriodNS() const override;
    /** Seconds, 0 for not periodic; false if negative. Takes effect at once and executes one trigger. */
    bool setPeriod(Seconds period) override;
    unsigned getCpuAffinity() const override;
    bool setCpuAffinity(unsigned cpuAffinity) override;
    /** Always false: only its own thread executes. */
    bool execute() override;
    /** False if not active. */
    bool trigger() override;
    /** False if periodic. If not active, it takes effect after the next start(). */
    bool timeout() override;
    os::ThreadInterface* thread() override;
    bool isSelf() const override;

protected:
    // These call the runner if there is one; a subclass without a runner may override them. A subclass with a runner
    // calls this initialize() in its own.
    bool initialize() override;
    void step() override;
    void loop() override;
    bool breakLoop() override;
    void finalize() override;
    virtual void work(base::RunnableInterface::WorkReason reason);

    void session() override;

private:
    void executeTriggered(std::uint32_t reasons);
    void executePeriod();
    void executeBetweenPeriods(bool starting);

    std::atomic<nsecs> updatePeriod_{0};
};

}  // namespace RTT
#endif
