// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DEFERRED_ACTIVITY_HPP
#define ORO_INTERNAL_DEFERRED_ACTIVITY_HPP

#include <rtt/base/ActivityInterface.hpp>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

namespace RTT {
class Activity;
namespace internal {

/**
 * Promises, while it exists, that the next TaskContext of that name that this thread constructs gets another activity
 * afterwards, so that a thread of its own is made only if somebody needs it before.
 */
class RTT_API ActivityFollows {
public:
    /** An empty name promises nothing. */
    explicit ActivityFollows(const std::string& component);
    ~ActivityFollows();
    ActivityFollows(const ActivityFollows&) = delete;
    ActivityFollows& operator=(const ActivityFollows&) = delete;

    /** True once for each promise. */
    static bool take(const std::string& component);

private:
    const std::string component_;
};

/**
 * A component's default activity whose thread is made when it has something to do, or when somebody looks at it. So the first
 * trigger() or timeout() is not real-time safe; it returns false if no thread can be made.
 *
 * What executes then is an Activity that TaskContext::getActivity() returns. This one stays the engine's, which those who send
 * may be visiting.
 */
class DeferredActivity : public base::ActivityInterface {
public:
    explicit DeferredActivity(const std::string& name);
    ~DeferredActivity() override;

    /** The activity that executes; made by the first call, with that period in seconds, and started if this one is. Any thread;
        not real-time safe. */
    Activity* made(Seconds period = 0.0);
    /** Null as long as there is none. Real-time safe. */
    Activity* ifMade() const { return made_.load(std::memory_order_acquire); }

    bool run(base::RunnableInterface* runner) override;
    bool start() override;
    bool stop() override;
    bool isRunning() const override;
    bool isActive() const override;
    Seconds getPeriod() const override;
    bool setPeriod(Seconds period) override;
    unsigned getCpuAffinity() const override;
    bool setCpuAffinity(unsigned cpuAffinity) override;
    bool execute() override;
    bool trigger() override;
    bool timeout() override;
    os::ThreadInterface* thread() override;
    bool isSelf() const override;

private:
    class Own;

    const std::string name_;
    std::mutex making_;
    std::unique_ptr<Own> own_;
    std::atomic<Activity*> made_{nullptr};
    std::atomic<bool> started_{false};  // counts as long as there is none
};

}  // namespace internal
}  // namespace RTT
#endif
