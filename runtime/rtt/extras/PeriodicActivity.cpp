// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/extras/PeriodicActivity.hpp>

#include <rtt/internal/engine/try_flag.hpp>
#include <rtt/os/futex.hpp>
#include <rtt/os/os_log.hpp>

#include <algorithm>
#include <cxxabi.h>
#include <exception>

namespace RTT::extras {

PeriodicActivity::PeriodicActivity(int priority, Seconds period, base::RunnableInterface* r)
    : PeriodicActivity(TimerThread::Instance(ORO_SCHED_RT, priority, period), r) {}
PeriodicActivity::PeriodicActivity(int scheduler, int priority, Seconds period, base::RunnableInterface* r)
    : PeriodicActivity(TimerThread::Instance(scheduler, priority, period), r) {}
PeriodicActivity::PeriodicActivity(int scheduler, int priority, Seconds period, unsigned cpuAffinity,
                                   base::RunnableInterface* r)
    : PeriodicActivity(TimerThread::Instance(scheduler, priority, period, cpuAffinity), r) {}
PeriodicActivity::PeriodicActivity(TimerThreadPtr thread, base::RunnableInterface* r) : thread_(thread) { adopt(r); }
PeriodicActivity::PeriodicActivity(Seconds period, TimerThreadPtr thread, base::RunnableInterface* r)
    : PeriodicActivity(thread, r) {
    thread_->setPeriod(period);
}
PeriodicActivity::PeriodicActivity(secs s, nsecs ns, TimerThreadPtr thread, base::RunnableInterface* r)
    : PeriodicActivity(nsecs_to_Seconds(secs_to_nsecs(s) + ns), thread, r) {}

PeriodicActivity::~PeriodicActivity() {
    closeGate();
    stop();
    thread_->removeActivity(this);  // waits for an execution that stopped itself or has not ended in time
}

bool PeriodicActivity::start() {
    const internal::TryFlag mine(changing_);
    if (!mine || active_ || !initialize()) return false;
    active_ = true;
    running_ = true;
    if (thread_->addActivity(this)) {
        if (thread_->startForActivity()) return true;
        thread_->removeActivity(this);
    }
    running_ = false;
    const internal::ActiveWhile active(active_);
    finalize();
    return false;
}

bool PeriodicActivity::stop() {
    const internal::TryFlag mine(changing_);
    if (!mine || !active_) return false;
    running_ = false;  // active_ stays until the last execution has ended
    const nsecs timeout = Seconds_to_nsecs(std::max(thread_->getStopTimeout(), 1.0));
    if (!thread_->removeActivity(this, os::detail::after(rtos_get_time_ns(), timeout))) {
        os::detail::log(os::detail::LogError, "PeriodicActivity",
                        "cannot stop a periodic activity: its step() has not returned in time");
        running_ = true;
        return false;
    }
    const internal::ActiveWhile active(active_);
    finalize();
    return true;
}

void PeriodicActivity::executePeriod() {
    try {
        step();
        work(base::RunnableInterface::TimeOut);
    } catch (abi::__forced_unwind&) {
        throw;
    } catch (const std::exception& e) {
        os::detail::log(os::detail::LogCritical, "PeriodicActivity",
                        std::string("activity stopped by an uncaught C++ exception: ") + e.what());
        stop();
    } catch (...) {
        os::detail::log(os::detail::LogCritical, "PeriodicActivity",
                        "activity stopped by an uncaught exception of unknown type");
        stop();
    }
}

bool PeriodicActivity::isRunning() const { return running_ && thread_->isRunning(); }
bool PeriodicActivity::isActive() const { return active_; }
Seconds PeriodicActivity::getPeriod() const { return thread_->getPeriod(); }
unsigned PeriodicActivity::getCpuAffinity() const { return thread_->getCpuAffinity(); }
bool PeriodicActivity::setCpuAffinity(unsigned cpuAffinity) { return thread_->setCpuAffinity(cpuAffinity); }
bool PeriodicActivity::isSelf() const {
    const int executor = executor_;
    return executor != 0 ? executor == os::detail::currentTid() : thread_->isSelf();
}
os::ThreadInterface* PeriodicActivity::thread() { return thread_.get(); }

base::ActivityInterface::Direct PeriodicActivity::beginDirect() {
    if (executor_ == os::detail::currentTid()) return Direct::Granted;
    // A thread in a cycle executes one activity after another, and other threads may execute this one meanwhile.
    return isSelf() && thread_->enterNow(*this) ? Direct::Entered : Direct::Refused;
}

base::ActivityInterface::Direct PeriodicActivity::beginInStead() {
    if (thread_->isActive() || executor_ == os::detail::currentTid()) return beginDirect();
    return thread_->enterNow(*this) ? Direct::Entered : Direct::Refused;
}

void PeriodicActivity::endDirect() { thread_->leave(*this); }

bool PeriodicActivity::initialize() { return claimRunner() && (!runner || runner->initialize()); }

void PeriodicActivity::step() {
    if (runner) runner->step();
}

void PeriodicActivity::work(base::RunnableInterface::WorkReason reason) {
    if (runner) runner->work(reason);
}

void PeriodicActivity::finalize() {
    if (runner) runner->finalize();
}

}  // namespace RTT::extras
