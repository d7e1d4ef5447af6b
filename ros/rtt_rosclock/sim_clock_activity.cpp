// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_rosclock/rtt_rosclock_sim_clock_activity.h>
#include <rtt_rosclock/rtt_rosclock_sim_clock_activity_manager.h>
#include <rtt_rosclock/rtt_rosclock_sim_clock_thread.h>

#include <algorithm>

namespace rtt_rosclock {

namespace {
RTT::nsecs toPeriod(RTT::Seconds period) { return period > 0 ? std::max<RTT::nsecs>(RTT::Seconds_to_nsecs(period), 1) : 0; }
}  // namespace

SimClockActivity::SimClockActivity(RTT::base::RunnableInterface* run, const std::string& name)
    : SimClockActivity(0.0, run, name) {}

SimClockActivity::SimClockActivity(RTT::Seconds period, RTT::base::RunnableInterface* run, const std::string& name)
    : SimClockActivity(SimClockThread::Instance(), period, run, name) {}

SimClockActivity::SimClockActivity(const boost::shared_ptr<SimClockThread>& thread, RTT::Seconds period,
                                   RTT::base::RunnableInterface* run, const std::string& name)
    : SlaveActivity(thread.get()),
      thread_(thread),
      manager_(SimClockActivityManager::Instance()),
      name_(name),
      period_(toPeriod(period)) {
    manager_->add(*this);
    adopt(run);
}

SimClockActivity::~SimClockActivity() {
    closeGate();  // waits for an execution in another thread
    stop();
    manager_->remove(*this);
}

bool SimClockActivity::start() {
    if (!isActive()) last_ = manager_->now();
    return SlaveActivity::start();
}

bool SimClockActivity::isRunning() const { return isActive(); }
RTT::Seconds SimClockActivity::getPeriod() const { return RTT::nsecs_to_Seconds(period_); }
bool SimClockActivity::isPeriodic() const { return true; }
bool SimClockActivity::execute() { return false; }
bool SimClockActivity::timeout() { return false; }
const std::string& SimClockActivity::getName() const { return name_; }

bool SimClockActivity::setPeriod(RTT::Seconds period) {
    if (!(period >= 0)) return false;
    period_ = toPeriod(period);
    return true;
}

bool SimClockActivity::trigger() {
    if (SlaveActivity::trigger()) return true;
    if (!isActive()) return false;
    // The queue of the thread is full. No caller would repeat this, and a waiting one would wait for ever.
    missedTrigger_ = true;
    manager_->noteMissedTrigger();
    return thread_->trigger();
}

// The thread of the simulation has no period, so the base class calls this.
void SimClockActivity::loop() { step(); }

RTT::nsecs SimClockActivity::nextDue(RTT::nsecs period) const { return (last_ / period + 1) * period; }

bool SimClockActivity::isDue(RTT::nsecs now, bool isClockTime) const {
    const RTT::nsecs period = period_;
    return isActive() && (period == 0 ? isClockTime : nextDue(period) <= now);
}

RTT::nsecs SimClockActivity::nextDueOr(RTT::nsecs limit) const {
    const RTT::nsecs period = period_;
    return period == 0 || !isActive() ? limit : std::min(limit, nextDue(period));
}

RTT::nsecs SimClockActivity::missed(RTT::nsecs now) const {
    const RTT::nsecs period = period_;
    return period == 0 || !isActive() ? 0 : now / period - last_ / period;
}

void SimClockActivity::executeAt(RTT::nsecs now) {
    last_ = now;
    SlaveActivity::execute();
}

}  // namespace rtt_rosclock
