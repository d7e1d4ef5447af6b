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
 * caller at a time. A trigger during execution returns at once; the executing thread continues while the runner has
 * messages, so none is lost. Writing to an event port of such a component runs the component in the writer's thread.
 */
class RTT_API SequentialActivity : public base::ActivityInterface {
public:
    explicit SequentialActivity(base::RunnableInterface* runner = nullptr);
    ~SequentialActivity() override;

    /** False if active, if initialize() returned false or if another thread is starting or stopping it. */
    bool start() override;
    /** Waits, at most one second, for an execution in another thread to end; false if it does not. */
    bool stop() override;
    /** True only while executing. */
    bool isRunning() const override;
    bool isActive() const override;
    Seconds getPeriod() const override { return 0.0; }
    /** Accepts only 0. */
    bool setPeriod(Seconds period) override { return period == 0.0; }
    unsigned getCpuAffinity() const override { return ~0u; }
    bool setCpuAffinity(unsigned) override { return false; }
    bool execute() override { return false; }
    bool trigger() override;
    bool timeout() override { return trigger(); }
    /** The main thread, because any thread may trigger. */
    os::ThreadInterface* thread() override;
    /** True in the thread that executes it; while it is not active, true in the main thread. */
    bool isSelf() const override;
    /** After a thread entered, other threads that trigger leave the execution to it. */
    Direct beginDirect() override;
    Direct beginInStead() override;
    void endDirect() override;

protected:
    // These call the runner if there is one; a sub-class may override them and have no runner. If it has a runner and
    // overrides initialize(), it must call this one. A sub-class must call stop() in its destructor.
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
