// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEDULE_SCHEDULED_ACTIVITY_HPP
#define OROFORGE_SCHEDULE_SCHEDULED_ACTIVITY_HPP

#include "scheduled_thread.hpp"

#include <rtt/base/ActivityInterface.hpp>
#include <rtt/extras/FileDescriptorActivityInterface.hpp>

#include <boost/shared_ptr.hpp>

#include <atomic>
#include <memory>
#include <mutex>
#include <set>
#include <string>

namespace OCL::schedule {

class Agenda;

/** What an activity does besides its periods. */
enum class Kind {
    Thread,     ///< executes when it is triggered, too: RTT::Activity
    Periods,    ///< executes messages at the next period only: PeriodicActivity
    FileEvents  ///< waits for file descriptors, which a replay does not have: its timeout is its period
};

/** How an activity is executed in a schedule. */
struct Timing {
    Kind kind = Kind::Thread;
    RTT::nsecs period = 0;
    int priority = 0, scheduler = 0;
};

/**
 * Executes a component in the thread of a schedule, at the times at which the activity that it replaces would, but in
 * simulated time: the period begins at the start.
 *
 * It is not real-time safe: it holds the lock of the agenda for some pointers. trigger(), timeout(), start() and stop()
 * may be called by any thread.
 */
class ScheduledActivity : public RTT::base::ActivityInterface {
public:
    /** @param replaced what the component was given; it is kept, because the component may have a pointer to it */
    ScheduledActivity(std::shared_ptr<Agenda> agenda, const std::string& component, unsigned order,
                      const Timing& timing, boost::shared_ptr<RTT::base::ActivityInterface> replaced);
    /** Waits for an execution in another thread; may be called within its own. */
    ~ScheduledActivity() override;

    bool start() override;
    bool stop() override;
    bool isRunning() const override;
    bool isActive() const override { return active_; }
    RTT::Seconds getPeriod() const override;
    /** As that of RTT::Activity: a new period begins now. That of a PeriodicActivity becomes a period of its own. */
    bool setPeriod(RTT::Seconds period) override;
    unsigned getCpuAffinity() const override { return thread_.getCpuAffinity(); }
    bool setCpuAffinity(unsigned cpus) override { return thread_.setCpuAffinity(cpus); }
    bool execute() override { return false; }
    bool trigger() override;
    bool timeout() override;
    RTT::os::ThreadInterface* thread() override { return &thread_; }
    bool isSelf() const override;

    const std::string& component() const { return component_; }
    /** Its present period ends in the order of the new priority. */
    void priorityChanged();

protected:
    /** For a new period. */
    void restart(RTT::nsecs period);
    std::atomic<bool> timedOut_{false};  // why it was executed last

private:
    friend class Agenda;
    /** A part of an execution, after which this object may be gone. */
    void run(unsigned reasons, const bool& gone);
    void work(RTT::base::RunnableInterface::WorkReason reason);

    const std::shared_ptr<Agenda> agenda_;
    const boost::shared_ptr<RTT::base::ActivityInterface> replaced_;
    const std::string component_;
    const unsigned order_;
    const Kind kind_;
    ScheduledThread thread_;
    std::atomic<RTT::nsecs> period_;
    std::atomic<bool> active_{false}, executing_{false};

    // Of the agenda, under its lock.
    RTT::nsecs due_ = 0;
    int duePriority_ = 0;
    bool planned_ = false, queued_ = false, foreign_ = false, last_ = false;
    unsigned reasons_ = 0;
    bool* gone_ = nullptr;  // set while it is executed
};

/** Replaces a FileDescriptorActivity. No descriptor is ever ready; a timeout comes in simulated time. */
class ScheduledFileActivity final : public ScheduledActivity, public RTT::extras::FileDescriptorActivityInterface {
public:
    using ScheduledActivity::ScheduledActivity;

    void watch(int fd) override;
    void unwatch(int fd) override;
    void clearAllWatches() override;
    bool isWatched(int fd) const override;
    bool isUpdated(int) const override { return false; }
    bool hasTimeout() const override { return timedOut_; }
    bool hasError() const override { return false; }
    void setTimeout(int milliseconds) override;
    void setTimeout_us(int microseconds) override;
    int getTimeout() const override { return getTimeout_us() / 1000; }
    int getTimeout_us() const override { return timeout_; }

private:
    mutable std::mutex mutex_;
    std::set<int> watched_;
    std::atomic<int> timeout_{0};  // microseconds
};

}  // namespace OCL::schedule

#endif
