// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "agenda.hpp"

#include "replaced_activity.hpp"
#include "scheduled_activity.hpp"

#include <rtt/Logger.hpp>
#include <rtt/os/fosi.h>
#include <rtt/os/futex.hpp>

#include <algorithm>
#include <chrono>

namespace OCL::schedule {
namespace {

/** A thread that has waited so long (ns) may wait for ever. */
constexpr std::int64_t kPatience = 5000000000;

template <class Queue>
void removeFrom(Queue& queue, const ScheduledActivity* activity) {
    queue.erase(std::remove(queue.begin(), queue.end(), activity), queue.end());
}

}  // namespace

bool Agenda::Due::operator<(const Due& other) const {
    if (time != other.time) return time < other.time;
    if (priority != other.priority) return priority > other.priority;
    if (order != other.order) return order < other.order;
    return activity < other.activity;
}

Agenda::Agenda() : thread_(RTT::os::detail::currentTid()) {}
Agenda::~Agenda() = default;

bool Agenda::isHere() const { return RTT::os::detail::currentTid() == thread_; }

unsigned Agenda::orderOf(const std::string& component) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return orders_.emplace(component, static_cast<unsigned>(orders_.size())).first->second;
}

boost::shared_ptr<RTT::base::ActivityInterface> Agenda::replace(boost::shared_ptr<RTT::base::ActivityInterface> given,
                                                                const std::string& component) {
    const std::optional<Timing> timing = timingOf(given.get(), component);
    if (!timing) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (hasOwnThread(*given)) ownThreads_.insert(component);
        return given;
    }
    const unsigned order = orderOf(component);
    if (timing->kind == Kind::FileEvents)
        return boost::shared_ptr<RTT::base::ActivityInterface>(
            new ScheduledFileActivity(shared_from_this(), component, order, *timing, given));
    return boost::shared_ptr<RTT::base::ActivityInterface>(
        new ScheduledActivity(shared_from_this(), component, order, *timing, given));
}

void Agenda::post(ScheduledActivity& activity, unsigned reasons) {
    const bool isForeign = !isHere();
    const std::lock_guard<std::mutex> lock(mutex_);
    if (countsStrangers_ && isForeign) ++strangers_[activity.component()];
    activity.reasons_ |= reasons;
    if (activity.queued_ && (isForeign || !activity.foreign_)) return;
    if (activity.queued_) removeFrom(foreign_, &activity);
    activity.queued_ = true;
    activity.foreign_ = isForeign;
    queueOf(activity).push_back(&activity);
}

std::deque<ScheduledActivity*>& Agenda::queueOf(const ScheduledActivity& activity) {
    return activity.foreign_ ? foreign_ : activity.last_ ? last_ : triggered_;
}

void Agenda::takeForeign() {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (ScheduledActivity* const activity : foreign_) {
        activity->foreign_ = false;
        queueOf(*activity).push_back(activity);
    }
    foreign_.clear();
}

void Agenda::plan(ScheduledActivity& activity, RTT::nsecs due) {
    const std::lock_guard<std::mutex> lock(mutex_);
    planLocked(activity, due);
}

void Agenda::replan(ScheduledActivity& activity) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (activity.planned_) planLocked(activity, activity.due_);
}

void Agenda::planLocked(ScheduledActivity& activity, RTT::nsecs due) {
    if (activity.planned_) due_.erase({activity.due_, activity.duePriority_, activity.order_, &activity});
    activity.planned_ = true;
    activity.due_ = due;
    activity.duePriority_ = activity.thread_.getPriority();
    due_.insert({due, activity.duePriority_, activity.order_, &activity});
}

void Agenda::removeLocked(ScheduledActivity& activity) {
    if (activity.planned_) due_.erase({activity.due_, activity.duePriority_, activity.order_, &activity});
    if (activity.queued_) removeFrom(queueOf(activity), &activity);
    activity.planned_ = activity.queued_ = false;
    activity.reasons_ = 0;
}

bool Agenda::forget(ScheduledActivity& activity, RTT::Seconds patience) {
    std::unique_lock<std::mutex> lock(mutex_);
    removeLocked(activity);
    if (!activity.gone_ || isHere()) return true;
    return ended_.wait_for(lock, std::chrono::duration<double>(patience), [&] { return !activity.gone_; });
}

void Agenda::executeLast(ScheduledActivity& activity) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (activity.queued_) removeFrom(queueOf(activity), &activity);
    activity.last_ = true;
    if (activity.queued_) queueOf(activity).push_back(&activity);
}

void Agenda::execute(ScheduledActivity& activity, unsigned reasons, std::unique_lock<std::mutex>& lock) {
    bool gone = false;
    activity.gone_ = &gone;
    activity.executing_ = true;
    lastExecuted_ = activity.component();
    ++executions_;
    idleSince_ = 0;
    lock.unlock();
    activity.run(reasons, gone);
    lock.lock();
    if (!gone) {
        activity.gone_ = nullptr;
        activity.executing_ = false;
    }
    ended_.notify_all();
}

// An activity that is waiting within its execution is left in the queue.
bool Agenda::executeFrom(std::deque<ScheduledActivity*>& queue) {
    std::unique_lock<std::mutex> lock(mutex_);
    const auto next = std::find_if(queue.begin(), queue.end(),
                                   [](const ScheduledActivity* activity) { return activity->gone_ == nullptr; });
    if (next == queue.end()) return false;
    ScheduledActivity& activity = **next;
    queue.erase(next);
    activity.queued_ = false;
    const unsigned reasons = activity.reasons_;
    activity.reasons_ = 0;
    execute(activity, reasons, lock);
    return true;
}

bool Agenda::executeOne() {
    takeForeign();
    const bool any = executeTriggered();
    if (!any) warnIfStuck();
    return any;
}

bool Agenda::executeTriggered() { return executeFrom(triggered_); }

bool Agenda::executeLastOne() { return executeFrom(last_); }

// Called again and again by a thread that waits.
void Agenda::warnIfStuck() {
    const std::int64_t now = rtos_get_time_ns();
    if (idleSince_ == 0) idleSince_ = now;
    if (isTold_ || now - idleSince_ < kPatience) return;
    isTold_ = true;
    RTT::log(RTT::Error) << "error: ["
                         << "RPL005"
                         << "] component '" << lastExecuted()
                         << "', or a script, has been waiting for 5 s for something that another component does later; "
                            "simulated time stands meanwhile"
                         << RTT::endlog();
}

void Agenda::executeDue(RTT::nsecs time) {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!due_.empty() && due_.begin()->time <= time) {
        const Due due = *due_.begin();
        due_.erase(due_.begin());
        ScheduledActivity& activity = *due.activity;
        activity.due_ = due.time + activity.period_;
        activity.duePriority_ = activity.thread_.getPriority();
        due_.insert({activity.due_, activity.duePriority_, activity.order_, &activity});
        if (!activity.gone_) execute(activity, TimeOut, lock);
    }
}

std::optional<RTT::nsecs> Agenda::nextDue() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return due_.empty() ? std::nullopt : std::optional<RTT::nsecs>(due_.begin()->time);
}

void Agenda::countStrangers() {
    const std::lock_guard<std::mutex> lock(mutex_);
    countsStrangers_ = true;
}

Agenda::Strangers Agenda::strangers() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return strangers_;
}

std::set<std::string> Agenda::ownThreads() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return ownThreads_;
}

std::string Agenda::lastExecuted() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return lastExecuted_;
}

}  // namespace OCL::schedule
