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
 * While it exists, it promises that the next TaskContext of that name constructed in this thread gets another activity
 * later. The component then makes a thread of its own only if it needs one before that.
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
 * A component's default activity. Its thread is made when there is something to do, or when it is first asked for. So
 * the first trigger() or timeout() is not real-time safe; it returns false if no thread can be made.
 *
 * From then on an Activity executes, which TaskContext::getActivity() returns. The engine keeps this one, because
 * senders may be visiting it.
 */
class DeferredActivity : public base::ActivityInterface {
public:
    explicit DeferredActivity(const std::string& name);
    ~DeferredActivity() override;

    /** The activity that executes. The first call makes it with that period in seconds, and starts it if this one is
        started. Any thread; not real-time safe. */
    Activity* made(Seconds period = 0.0);
    /** Null until made() was called. Real-time safe. */
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
    std::atomic<bool> started_{false};  // valid while own_ is null
};

}  // namespace internal
}  // namespace RTT
#endif
