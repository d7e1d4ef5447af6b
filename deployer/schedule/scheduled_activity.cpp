// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "scheduled_activity.hpp"

#include "agenda.hpp"

#include <rtt/Logger.hpp>
#include <rtt/base/RunnableInterface.hpp>
#include <rtt/os/TimeService.hpp>

#include <algorithm>
#include <exception>
#include <limits>

namespace OCL::schedule {
namespace {

constexpr RTT::Seconds kStopTime = 1, kForever = 1e9;

RTT::nsecs now() { return RTT::os::TimeService::Instance()->getNSecs(); }

/** At least 1 ns, so that it stays periodic, and at most what can be added to the time. */
RTT::nsecs inNs(RTT::Seconds period) {
    return period > 0 ? std::clamp<RTT::nsecs>(RTT::Seconds_to_nsecs(period), 1, RTT::InfiniteNSecs / 4) : 0;
}

}  // namespace

ScheduledActivity::ScheduledActivity(std::shared_ptr<Agenda> agenda, const std::string& component, unsigned order,
                                     const Timing& timing, boost::shared_ptr<RTT::base::ActivityInterface> replaced)
    : agenda_(std::move(agenda)),
      replaced_(std::move(replaced)),
      component_(component),
      order_(order),
      kind_(timing.kind),
      thread_(component, timing.scheduler, timing.priority, *this),
      period_(timing.period) {}

ScheduledActivity::~ScheduledActivity() {
    closeGate();
    ScheduledActivity::stop();
    (void)agenda_->forget(*this, kForever);
    if (gone_) *gone_ = true;  // within its own execution
}

bool ScheduledActivity::isSelf() const { return agenda_->isHere(); }
bool ScheduledActivity::isRunning() const { return active_ && (period_ != 0 || executing_); }
RTT::Seconds ScheduledActivity::getPeriod() const { return RTT::nsecs_to_Seconds(period_); }

bool ScheduledActivity::start() {
    if (active_) return kind_ == Kind::Thread && period_ == 0 && trigger();
    if (!claimRunner() || (runner && !runner->initialize())) return false;
    active_ = true;
    if (const RTT::nsecs period = period_) agenda_->plan(*this, now() + period);
    if (kind_ != Kind::Periods) agenda_->post(*this, Agenda::Start);
    return true;
}

bool ScheduledActivity::stop() {
    if (!active_.exchange(false)) return false;
    if (!agenda_->forget(*this, kStopTime)) {
        active_ = true;
        RTT::log(RTT::Error) << component_ << ": cannot be stopped: its present step does not end" << RTT::endlog();
        return false;
    }
    if (runner) runner->finalize();
    return true;
}

bool ScheduledActivity::setPeriod(RTT::Seconds period) {
    if (!(period >= 0) || kind_ == Kind::FileEvents) return false;
    restart(inNs(period));
    return true;
}

void ScheduledActivity::restart(RTT::nsecs period) {
    period_ = period;
    if (!active_) return;
    agenda_->plan(*this, period == 0 ? std::numeric_limits<RTT::nsecs>::max() : now() + period);
    if (kind_ == Kind::Thread) agenda_->post(*this, Agenda::Trigger);
}

void ScheduledActivity::priorityChanged() { agenda_->replan(*this); }

bool ScheduledActivity::trigger() {
    if (!active_ || kind_ == Kind::Periods) return false;
    agenda_->post(*this, Agenda::Trigger);
    return true;
}

bool ScheduledActivity::timeout() {
    if (!active_ || kind_ == Kind::Periods || (kind_ == Kind::Thread && period_ != 0)) return false;
    agenda_->post(*this, Agenda::TimeOut);
    return true;
}

// As the session of an RTT::Activity. The runner may lose this activity, and the activity be destroyed, in each call.
void ScheduledActivity::run(unsigned reasons, const bool& gone) {
    typedef RTT::base::RunnableInterface Runnable;
    try {
        if ((reasons & Agenda::TimeOut) && active_) {
            timedOut_ = true;
            if (runner) runner->step();
            if (!gone) work(Runnable::TimeOut);
        }
        if (gone || !active_ || !(reasons & (Agenda::Trigger | Agenda::Start))) return;
        timedOut_ = false;
        const bool hasLoop = kind_ == Kind::Thread && period_ == 0;
        if (runner && hasLoop)
            runner->loop();
        else if (runner && (reasons & Agenda::Trigger))
            runner->step();
        if (!gone) work(Runnable::Trigger);
    } catch (const std::exception& thrown) {
        RTT::log(RTT::Critical) << "an activity is stopped by an uncaught exception: " << thrown.what()
                                << RTT::endlog();
        if (!gone) stop();
    }
}

void ScheduledActivity::work(RTT::base::RunnableInterface::WorkReason reason) {
    if (runner) runner->work(reason);
}

void ScheduledFileActivity::watch(int fd) {
    const std::lock_guard<std::mutex> lock(mutex_);
    watched_.insert(fd);
}

void ScheduledFileActivity::unwatch(int fd) {
    const std::lock_guard<std::mutex> lock(mutex_);
    watched_.erase(fd);
}

void ScheduledFileActivity::clearAllWatches() {
    const std::lock_guard<std::mutex> lock(mutex_);
    watched_.clear();
}

bool ScheduledFileActivity::isWatched(int fd) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return watched_.count(fd) != 0;
}

void ScheduledFileActivity::setTimeout(int milliseconds) {
    setTimeout_us(milliseconds > std::numeric_limits<int>::max() / 1000 ? std::numeric_limits<int>::max()
                                                                        : milliseconds * 1000);
}

void ScheduledFileActivity::setTimeout_us(int microseconds) {
    if (microseconds < 0) {
        RTT::log(RTT::Error) << "'" << component() << "': invalid timeout of " << microseconds
                             << " us, expected one that is not negative" << RTT::endlog();
        return;
    }
    timeout_ = microseconds;
    restart(RTT::nsecs(microseconds) * 1000);
}

}  // namespace OCL::schedule
