// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_SLAVE_ACTIVITY_HPP
#define ORO_EXTRAS_SLAVE_ACTIVITY_HPP

#include <rtt/base/ActivityInterface.hpp>

#include <atomic>

namespace RTT {
namespace extras {

/**
 * An activity that runs when somebody calls execute(), that is TaskContext::update(), in the caller's thread. With a
 * master, trigger() also has the master's engine execute work(Trigger); the master must outlive the slave. Without a
 * master, operations sent to it wait for the next execute().
 */
class RTT_API SlaveActivity : public base::ActivityInterface {
public:
    /** Period, CPU affinity and thread are those of the master. */
    explicit SlaveActivity(base::ActivityInterface* master, base::RunnableInterface* runner = nullptr);
    /** No master; getPeriod() returns `period`. */
    explicit SlaveActivity(double period, base::RunnableInterface* runner = nullptr);
    explicit SlaveActivity(base::RunnableInterface* runner = nullptr);
    ~SlaveActivity() override;

    /** False, with an error in the log, if active already or if the master is not active. */
    bool start() override;
    /** False if not active. */
    bool stop() override;
    bool isRunning() const override;
    bool isActive() const override;
    Seconds getPeriod() const override;
    /** With a master: false. Without: any period ≥ 0 that keeps it periodic or not periodic. */
    bool setPeriod(Seconds period) override;
    /** As it was at construction. */
    bool isPeriodic() const override;
    unsigned getCpuAffinity() const override;
    bool setCpuAffinity(unsigned cpuAffinity) override;
    /**
     * One cycle in the calling thread: step() and work(TimeOut), or loop() and work(TimeOut) if not periodic. False if
     * not active or executing already.
     */
    bool execute() override;
    /** False without a master, if not active or if the runner of the master takes no messages. */
    bool trigger() override;
    /** Forwarded to the master; false without one. */
    bool timeout() override;
    os::ThreadInterface* thread() override;
    bool isSelf() const override;

private:
    class TriggerMessage;
    void executeTrigger();
    bool enter();
    void servePending();

    base::ActivityInterface* const master_;
    double period_;
    const bool periodic_;
    std::atomic<bool> active_{false};
    std::atomic<int> executor_{0};      // Linux id of the executing thread, 0: nobody
    std::atomic<bool> pending_{false};  // work(Trigger) is due
    TriggerMessage* message_;           // shared with the queue of the master's engine
};

}  // namespace extras
}  // namespace RTT
#endif
