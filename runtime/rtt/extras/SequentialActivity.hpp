// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_SEQUENTIAL_ACTIVITY_HPP
#define ORO_EXTRAS_SEQUENTIAL_ACTIVITY_HPP

#include <rtt/base/ActivityInterface.hpp>

#include <atomic>
#include <cstdint>

namespace RTT {
namespace extras {

/**
 * An activity without a thread: trigger() and timeout() execute step() and work(TimeOut) in the calling thread, one
 * caller at a time. A trigger during execution returns at once; the executing thread goes on while the runner has
 * messages, so none is forgotten. Writing to an event port of such a component runs the component in the writer's thread.
 */
class RTT_API SequentialActivity : public base::ActivityInterface {
public:
    explicit SequentialActivity(base::RunnableInterface* runner = nullptr);
    ~SequentialActivity() override;

    /** False if active, if initialize() returned false or if another thread is starting or stopping it. */
    bool start() override;
    /** Waits, at most one second, for an execution in another thread to end; false if it did not. */
    bool stop() override;
    /** True only while executing. */
    bool isRunning() const override;
    bool isActive() const override;
    Seconds getPeriod() const override { return 0.0; }
    /** Only 0 is accepted. */
    bool setPeriod(Seconds period) override { return period == 0.0; }
    unsigned getCpuAffinity() const override { return ~0u; }
    bool setCpuAffinity(unsigned) override { return false; }
    bool execute() override { return false; }
    bool trigger() override;
    bool timeout() override { return trigger(); }
    /** The main thread stands in for whoever triggers. */
    os::ThreadInterface* thread() override;
    /** True in the thread that executes; in the main thread while nobody can, because it is not active. */
    bool isSelf() const override;
    /** While a thread has entered, others that trigger leave the execution to it. */
    Direct beginDirect() override;
    Direct beginInStead() override;
    void endDirect() override;

protected:
    // These call the runner if there is one; a sub-class may override them and have no runner. One that has a runner and
    // overrides initialize() calls this one in it. A sub-class calls stop() in its destructor.
    virtual bool initialize();
    virtual void step();
    virtual void finalize();
    virtual void work(base::RunnableInterface::WorkReason reason);

private:
    static constexpr std::uint32_t kWaiting = 0x80000000u;  // in requests_: stop() waits for the end of the execution
    void executeOnce();
    bool isExecutor() const;
    void executeWhileWork();
    void finishWork();
    void free();
    bool leave(std::uint32_t& seen);
    bool waitForExecution(nsecs deadline);

    std::atomic<bool> active_{false};
    std::atomic<bool> open_{false};  // may be executed; active_ stays until stop() has waited for the last execution
    std::atomic<bool> changing_{false};       // within start() or stop()
    std::atomic<std::uint32_t> requests_{0};  // triggers since a thread began, or entered; 0: nobody executes
    std::atomic<int> executor_{0};            // Linux id of the executing thread
};

}  // namespace extras
}  // namespace RTT
#endif
