// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEDULE_AGENDA_HPP
#define OROFORGE_SCHEDULE_AGENDA_HPP

#include <rtt/Time.hpp>
#include <rtt/internal/engine/other_order.hpp>

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace OCL::schedule {

class ScheduledActivity;

/**
 * What is to be executed: activities whose period is over, and those that something has triggered. Shared by the
 * schedule and its activities, which may exist longer. Any thread may trigger, start and stop an activity; only one
 * thread, in which the agenda was made, executes them.
 *
 * The mutex is held for a few pointers only, never while an activity executes.
 */
class Agenda final : public RTT::internal::OtherOrder, public std::enable_shared_from_this<Agenda> {
public:
    /** Why an activity executes; bits. */
    enum Reason : unsigned { Start = 1, Trigger = 2, TimeOut = 4 };
    /** Components that other threads have triggered, and how often. */
    typedef std::map<std::string, unsigned long> Strangers;

    Agenda();
    ~Agenda() override;

    boost::shared_ptr<RTT::base::ActivityInterface> replace(boost::shared_ptr<RTT::base::ActivityInterface> given,
                                                            const std::string& component) override;
    bool executeOne() override;

    /** Executes an activity that was triggered; false if there is none. executeOne() is the same for a thread that
        waits. */
    bool executeTriggered();
    /** What other threads have triggered until now is executed by executeTriggered(), too. */
    void takeForeign();
    /** Executes an activity of executeLast() that was triggered. */
    bool executeLastOne();
    /** Executes, in their order, the activities whose period ends at that time, or earlier. */
    void executeDue(RTT::nsecs time);
    /** When the next period ends; none if nothing is periodic. */
    std::optional<RTT::nsecs> nextDue() const;
    /** The activity is executed when nothing else is left to execute at a time. */
    void executeLast(ScheduledActivity& activity);
    /** True if the caller is the thread that executes. */
    bool isHere() const;
    /** From now on triggers of other threads are counted: a deployment is complete, and its thread executes. */
    void countStrangers();
    Strangers strangers() const;
    /** The components that keep a thread of their own. */
    std::set<std::string> ownThreads() const;
    /** The name of the component that was executed last. */
    std::string lastExecuted() const;
    unsigned long executions() const { return executions_; }

    // For activities.
    void post(ScheduledActivity& activity, unsigned reasons);
    /** Its next period ends at that time. */
    void plan(ScheduledActivity& activity, RTT::nsecs due);
    /** With its new priority. */
    void replan(ScheduledActivity& activity);
    /** It is not executed any more. Unless called within its own execution, waits for the end of that, at most so long;
        false if it did not end. */
    bool forget(ScheduledActivity& activity, RTT::Seconds patience);

private:
    struct Due {
        RTT::nsecs time;
        int priority;
        unsigned order;
        ScheduledActivity* activity;
        bool operator<(const Due& other) const;
    };

    unsigned orderOf(const std::string& component);
    void execute(ScheduledActivity& activity, unsigned reasons, std::unique_lock<std::mutex>& lock);
    std::deque<ScheduledActivity*>& queueOf(const ScheduledActivity& activity);
    void planLocked(ScheduledActivity& activity, RTT::nsecs due);
    void removeLocked(ScheduledActivity& activity);
    bool executeFrom(std::deque<ScheduledActivity*>& queue);
    void warnIfStuck();

    mutable std::mutex mutex_;
    std::condition_variable ended_;  // an execution, for threads in forget()
    std::set<Due> due_;
    std::deque<ScheduledActivity*> triggered_, last_, foreign_;
    std::map<std::string, unsigned> orders_;  // of the components, in the order of their creation
    Strangers strangers_;
    std::set<std::string> ownThreads_;
    bool countsStrangers_ = false;
    std::string lastExecuted_;
    const int thread_;
    unsigned long executions_ = 0;
    std::int64_t idleSince_ = 0;  // monotonic ns; 0: something was executed
    bool isTold_ = false;
};

}  // namespace OCL::schedule

#endif
