// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_SLAVE_ACTIVITY_HPP
#define ORO_EXTRAS_SLAVE_ACTIVITY_HPP

#include <rtt/base/ActivityInterface.hpp>

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

namespace RTT {
namespace extras {

/**
 * An activity that runs when somebody calls execute(), that is TaskContext::update(), in the caller's thread. Without a
 * master, operations sent to it wait for the next execute().
 *
 * With a master, timeout(), that is TaskContext::trigger(), does the same when the thread of the master calls it, and
 * trigger() has the engine of the master execute work(Trigger). A master may be destroyed before its slaves: they can
 * still be executed and stopped then, but neither triggered nor started.
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
    /**
     * False if not active. Waits, at most one second, for an execution in another thread to end; false if it did not, and
     * then it stays active.
     */
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
     * not active or executing already. Costs some microseconds more, and may wait as long for another thread that asks at the
     * same moment, if it is not the thread that executed it last.
     */
    bool execute() override;
    /** False without a master, if not active or if the runner of the master takes no messages. */
    bool trigger() override;
    /** By the master's thread: execute(). By others, and within execute(): forwarded to the master; false without one. */
    bool timeout() override;
    os::ThreadInterface* thread() override;
    /** Without a master, or after that was destroyed: in the thread that executed it last; in the main thread if there is none
        or it has ended. */
    bool isSelf() const override;
    /** While it has entered, execute() by others is refused, as during an execution. */
    Direct beginDirect() override;
    /** Refused while there is a master that executes it. */
    Direct beginInStead() override;
    void endDirect() override;

protected:
    // These call the runner if there is one; a sub-class may override them and have no runner. One that has a runner and
    // overrides initialize() calls this one in it. A sub-class calls stop() in its destructor.
    virtual bool initialize();
    virtual void step();
    /** Default, without a runner: step(). */
    virtual void loop();
    virtual void finalize();
    virtual void work(base::RunnableInterface::WorkReason reason);

private:
    class TriggerMessage;
    typedef std::atomic<std::uintptr_t> Place;  // internal::Presence::Place
    struct Leave;
    template <class Ask>
    auto ofMaster(Ask&& ask, decltype(ask(std::declval<base::ActivityInterface&>())) otherwise) const;
    bool activate();
    void executeTrigger();
    Place* enter();
    Place* takeOver();
    bool isUpdater() const;
    Direct claim(Place*& place);
    bool isExecutor() const;
    void executeOnce();
    void servePending();
    bool waitForExecution(nsecs deadline) const;

    base::ActivityInterface* const master_;  // used by ofMaster() only
    const std::shared_ptr<internal::AccessGate> masterGate_;
    std::atomic<double> period_;
    const bool periodic_;
    std::atomic<bool> active_{false};
    std::atomic<bool> open_{false};      // may be executed; active_ stays until stop() has waited for an execution
    std::atomic<bool> changing_{false};  // within start() or stop()
    // Linux ids of threads: the one that executes it, 0 for none; the one that may enter without asking others; and the one that
    // made the last step, 0 for main.
    std::atomic<int> executor_{0}, owner_{0}, updater_{0};
    std::atomic<std::uint32_t> handover_{0};  // locked while owner_ changes
    std::atomic<bool> pending_{false};        // work(Trigger) is due
    Place* direct_ = nullptr;                 // of the thread that makes a direct call
    TriggerMessage* message_;                 // shared with the queue of the master's engine
};

}  // namespace extras
}  // namespace RTT
#endif
