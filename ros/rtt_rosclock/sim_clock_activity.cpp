// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_rosclock/rtt_rosclock_sim_clock_activity.h>
#include <rtt_rosclock/rtt_rosclock_sim_clock_activity_manager.h>
#include <rtt_rosclock/rtt_rosclock_sim_clock_thread.h>

#include <rtt/Logger.hpp>

#include <algorithm>
#include <cxxabi.h>
#include <exception>

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

// A multiple of the period since the last time. In a step of the clock: that is now, or, if it skips some, the last one
// when the step ends. start() and setPeriod() of other threads may come between nextDueAfter() and this.
bool SimClockActivity::isDue(RTT::nsecs now, bool isClockTime, bool isStep) const {
    const RTT::nsecs period = period_;
    if (!isActive()) return false;
    if (period == 0) return isClockTime;
    const RTT::nsecs latest = now / period * period;
    if (latest <= last_) return false;
    if (!isStep) return true;
    return skips_ ? isClockTime : latest == now;
}

// Never before `now`: another thread may start it, or change its period, with an earlier time in mind.
RTT::nsecs SimClockActivity::nextDueAfter(RTT::nsecs now, RTT::nsecs limit) const {
    const RTT::nsecs period = period_;
    if (period == 0 || !isActive() || skips_) return limit;
    return std::min(limit, (std::max<RTT::nsecs>(last_, now) / period + 1) * period);
}

RTT::nsecs SimClockActivity::missed(RTT::nsecs now, RTT::nsecs until) const {
    const RTT::nsecs period = period_;
    return period == 0 || !isActive() ? 0 : until / period - std::max<RTT::nsecs>(last_, now) / period;
}

template <class Function>
void SimClockActivity::stopIfThrown(Function&& function) {
    std::string what = "its type is unknown";
    try {
        return function();
    } catch (abi::__forced_unwind&) {
        throw;
    } catch (const std::exception& thrown) {
        what = thrown.what();
    } catch (...) {
    }
    RTT::log(RTT::Critical) << getName() << ": its activity in simulated time is stopped, because an exception left it: "
                            << what << RTT::endlog();
    stop();
}

void SimClockActivity::executeAt(RTT::nsecs now) {
    last_ = now;
    stopIfThrown([this] { SlaveActivity::execute(); });
}

void SimClockActivity::work(RTT::base::RunnableInterface::WorkReason reason) {
    stopIfThrown([&] { SlaveActivity::work(reason); });
}

}  // namespace rtt_rosclock
