// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_rosclock/rtt_rosclock_sim_clock_activity.h>
#include <rtt_rosclock/rtt_rosclock_sim_clock_activity_manager.h>

#include <rtt/os/TimeService.hpp>

#include <algorithm>

namespace rtt_rosclock {

boost::shared_ptr<SimClockActivityManager> SimClockActivityManager::Instance() {
    static const boost::shared_ptr<SimClockActivityManager> one(new SimClockActivityManager);
    return one;
}

RTT::Seconds SimClockActivityManager::getSimulationPeriod() const { return RTT::nsecs_to_Seconds(period_); }
void SimClockActivityManager::setSimulationPeriod(RTT::Seconds period) { period_ = RTT::Seconds_to_nsecs(period); }

void SimClockActivityManager::add(SimClockActivity& activity) {
    const std::lock_guard<std::mutex> lock(mutex_);
    activities_.push_back({&activity, activity.gate()});
    ++version_;
}

void SimClockActivityManager::remove(SimClockActivity& activity) {
    const std::lock_guard<std::mutex> lock(mutex_);
    activities_.erase(std::find_if(activities_.begin(), activities_.end(),
                                   [&](const Entry& entry) { return entry.activity == &activity; }));
    ++version_;
}

// Of all that exist when it begins, in order of creation. Others may be created and destroyed meanwhile.
template <class Function>
void SimClockActivityManager::forEach(Function&& function) {
    if (version_ != snapshotVersion_) {
        const std::lock_guard<std::mutex> lock(mutex_);
        snapshot_ = activities_;
        snapshotVersion_ = version_;
    }
    for (const Entry& entry : snapshot_) {
        const RTT::internal::AccessGate::Pass pass(entry.gate);
        if (pass) function(*entry.activity);
    }
}

void SimClockActivityManager::update(bool isClockTime) {
    execute(RTT::os::TimeService::Instance()->getNSecs(), isClockTime, false, [] { return true; });
}

void SimClockActivityManager::execute(RTT::nsecs now, bool isClockTime, bool isStep, const std::function<bool()>& goesOn) {
    now_ = now;
    forEach([&](SimClockActivity& activity) {
        if (activity.isDue(now, isClockTime, isStep) && goesOn()) activity.executeAt(now);
    });
}

void SimClockActivityManager::beginStep() {
    const RTT::nsecs now = now_;
    skips_ = {};
    forEach([&](SimClockActivity& activity) {
        // It was started while the time was set back.
        if (activity.last_ > now) activity.last_ = now;
        activity.skips_ = false;
    });
}

RTT::nsecs SimClockActivityManager::nextDue(RTT::nsecs end) {
    const RTT::nsecs now = now_, limit = catchUpLimit_;
    RTT::nsecs next = end;
    forEach([&](SimClockActivity& activity) {
        const RTT::nsecs missed = activity.skips_ ? 0 : activity.missed(now, end);
        if (missed > limit) {
            activity.skips_ = true;
            ++skips_.activities;
            if (missed > skips_.most) {
                skips_.most = missed;
                skips_.busiest = activity.getName();
            }
        }
        next = std::min(next, activity.nextDueAfter(now, end));
    });
    return next;
}

void SimClockActivityManager::reset(RTT::nsecs now) {
    now_ = now;
    forEach([&](SimClockActivity& activity) { activity.last_ = now; });
}

void SimClockActivityManager::repeatMissedTriggers() {
    if (!missedTriggers_.exchange(false)) return;
    forEach([](SimClockActivity& activity) {
        if (activity.missedTrigger_.exchange(false)) activity.trigger();
    });
}

}  // namespace rtt_rosclock
