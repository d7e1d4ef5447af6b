// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/extras/PeriodicActivity.hpp>

#include <rtt/os/detail/os_log.hpp>

#include <cxxabi.h>
#include <exception>

namespace RTT {
namespace extras {

PeriodicActivity::PeriodicActivity(int priority, Seconds period, base::RunnableInterface* r)
    : PeriodicActivity(TimerThread::Instance(ORO_SCHED_RT, priority, period), r) {}
PeriodicActivity::PeriodicActivity(int scheduler, int priority, Seconds period, base::RunnableInterface* r)
    : PeriodicActivity(TimerThread::Instance(scheduler, priority, period), r) {}
PeriodicActivity::PeriodicActivity(int scheduler, int priority, Seconds period, unsigned cpuAffinity,
                                   base::RunnableInterface* r)
    : PeriodicActivity(TimerThread::Instance(scheduler, priority, period, cpuAffinity), r) {}
PeriodicActivity::PeriodicActivity(TimerThreadPtr thread, base::RunnableInterface* r)
    : base::ActivityInterface(r), thread_(thread) {}
PeriodicActivity::PeriodicActivity(Seconds period, TimerThreadPtr thread, base::RunnableInterface* r)
    : PeriodicActivity(thread, r) {
    thread_->setPeriod(period);
}
PeriodicActivity::PeriodicActivity(secs s, nsecs ns, TimerThreadPtr thread, base::RunnableInterface* r)
    : PeriodicActivity(nsecs_to_Seconds(secs_to_nsecs(s) + ns), thread, r) {}

PeriodicActivity::~PeriodicActivity() { stop(); }

bool PeriodicActivity::start() {
    if (active_ || !initialize()) return false;
    active_ = true;
    running_ = true;
    if (thread_->addActivity(this)) {
        if (thread_->isActive() || thread_->start() || thread_->isActive()) return true;
        thread_->removeActivity(this);
    }
    running_ = false;
    active_ = false;
    finalize();
    return false;
}

bool PeriodicActivity::stop() {
    if (!active_.exchange(false)) return false;
    running_ = false;
    thread_->removeActivity(this);
    finalize();
    return true;
}

void PeriodicActivity::executePeriod() {
    if (!running_) return;
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
os::ThreadInterface* PeriodicActivity::thread() { return thread_.get(); }

bool PeriodicActivity::initialize() { return !runner || runner->initialize(); }

void PeriodicActivity::step() {
    if (runner) runner->step();
}

void PeriodicActivity::work(base::RunnableInterface::WorkReason reason) {
    if (runner) runner->work(reason);
}

void PeriodicActivity::finalize() {
    if (runner) runner->finalize();
}

}  // namespace extras
}  // namespace RTT
