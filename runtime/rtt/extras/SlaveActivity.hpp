// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_SLAVE_ACTIVITY_HPP
#define ORO_EXTRAS_SLAVE_ACTIVITY_HPP

#include <rtt/base/ActivityInterface.hpp>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace RTT {
namespace extras {

/**
 * An activity that runs in the thread that calls execute(), as TaskContext::update() does. Without a master, operations
 * sent to it wait for the next execute().
 *
 * With a master, timeout(), which TaskContext::trigger() calls, does the same in the thread of the master, and
 * trigger() makes the engine of the master execute work(Trigger). A master may be destroyed before its slaves; these
 * can still be executed and stopped, but neither triggered nor started.
 *
 * Code that executes slaves in an order may have their triggers wait for their turn, see setInTurn().
 */
class RTT_API SlaveActivity : public base::ActivityInterface {
public:
    /** Period, CPU affinity and thread are those of the master. */
    explicit SlaveActivity(base::ActivityInterface* master, base::RunnableInterface* runner = nullptr);
    /** No master; getPeriod() returns `period`. */
    explicit SlaveActivity(double period, base::RunnableInterface* runner = nullptr);
    explicit SlaveActivity(base::RunnableInterface* runner = nullptr);
    ~SlaveActivity() override;

    /** Logs an error and returns false if it is active already or if the master is not active. */
    bool start() override;
    /**
     * False if not active. Waits, at most one second, for an execution in another thread to end; if it does not,
     * returns false and stays active.
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
     * Executes one cycle in the calling thread: step() and work(TimeOut), or loop() and work(TimeOut) if not periodic.
     * False if not active or executing already. If another thread executed it last, this takes some microseconds more,
     * and may wait as long for a third thread that calls at the same moment.
     */
    bool execute() override;
    /** False without a master, if not active or if the runner of the master takes no messages. */
    bool trigger() override;
    /** In the master's thread: execute(). In other threads, and within execute(): forwards to the master; false without
        one. */
    bool timeout() override;
    os::ThreadInterface* thread() override;
    /** Without a master, or after that was destroyed: true in the thread that executed it last, or in the main thread
        if there is none or it has ended. */
    bool isSelf() const override;
    /** After a thread entered, execute() in other threads is refused, as during an execution. */
    Direct beginDirect() override;
    /**
     * While true, the slave is executed in its turn only: timeout() requests nothing, and if the master is periodic,
     * the engine of that leaves messages and callbacks of the slave to the next execute() or serve(), unless the
     * thread of the master waits for something, which may depend on them. For code that calls one of the two in each
     * cycle of the master. False, as at first, triggers the slave if there is work left. Any thread; real-time safe.
     */
    void setInTurn(bool inTurn);
    /** Executes the messages and callbacks of the slave in the calling thread, if there are any, but no cycle. False as
        for execute(). */
    bool serve();
    bool hasMaster() const { return masterGate_ != nullptr; }
    /** True if `master` is the master, even if either was destroyed. Real-time safe. */
    bool isSlaveOf(const base::ActivityInterface& master) const;
    /** The name of the component that the master executes; empty if there is none. Not real-time safe. */
    std::string masterName() const;
    /** Refused while there is a master that executes it. */
    Direct beginInStead() override;
    void endDirect() override;

protected:
    // These call the runner if there is one; a sub-class may override them and have no runner. If it has a runner and
    // overrides initialize(), it must call this one. A sub-class must call stop() in its destructor.
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
    bool awaitsTurn() const;
    bool waitForExecution(nsecs deadline) const;

    base::ActivityInterface* const master_;  // used only by ofMaster()
    const std::shared_ptr<internal::AccessGate> masterGate_;
    std::atomic<double> period_;
    const bool periodic_;
    std::atomic<bool> active_{false};
    std::atomic<bool> open_{false};      // may be executed; active_ stays until stop() has waited for an execution
    std::atomic<bool> changing_{false};  // within start() or stop()
    // Linux ids of threads: the one that executes it, 0 for none; the one that may enter without asking others; and the
    // one that made the last step, 0 for main.
    std::atomic<int> executor_{0}, owner_{0}, updater_{0};
    std::atomic<std::uint32_t> handover_{0};  // locked while owner_ changes
    std::atomic<bool> pending_{false};        // work(Trigger) is due
    std::atomic<bool> inTurn_{false};         // see setInTurn()
    Place* direct_ = nullptr;                 // of the thread that makes a direct call
    TriggerMessage* message_;                 // shared with the queue of the master's engine
};

}  // namespace extras
}  // namespace RTT
#endif
