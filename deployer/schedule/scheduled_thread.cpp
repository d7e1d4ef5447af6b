// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "scheduled_activity.hpp"

#include <rtt/os/fosi.h>

#include <algorithm>
#include <utility>

namespace OCL::schedule {

ScheduledThread::ScheduledThread(std::string name, int scheduler, int priority, ScheduledActivity& activity)
    : name_(std::move(name)), activity_(activity), scheduler_(scheduler), priority_(priority) {}

bool ScheduledThread::start() { return activity_.start(); }
bool ScheduledThread::stop() { return activity_.stop(); }
bool ScheduledThread::isRunning() const { return activity_.isRunning(); }
bool ScheduledThread::isActive() const { return activity_.isActive(); }
bool ScheduledThread::setPeriod(RTT::Seconds period) { return activity_.setPeriod(period); }
RTT::Seconds ScheduledThread::getPeriod() const { return activity_.getPeriod(); }
RTT::nsecs ScheduledThread::getPeriodNS() const { return RTT::Seconds_to_nsecs(activity_.getPeriod()); }
bool ScheduledThread::isSelf() const { return activity_.isSelf(); }

bool ScheduledThread::setScheduler(int scheduler) {
    if (scheduler != ORO_SCHED_RT && scheduler != ORO_SCHED_OTHER) return false;
    scheduler_ = scheduler;
    return true;
}

bool ScheduledThread::setPriority(int priority) {
    priority_ = std::clamp(priority, 0, 99);
    activity_.priorityChanged();
    return true;
}

bool ScheduledThread::setCpuAffinity(unsigned cpus) {
    cpus_ = cpus;
    return true;
}

}  // namespace OCL::schedule
