// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Activity.hpp>

#include <algorithm>

namespace RTT {

namespace {
// Reasons to wake the thread, in addition to those of os::Thread.
constexpr std::uint32_t kTrigger = 8u;
constexpr std::uint32_t kTimeout = 16u;
constexpr std::uint32_t kNewPeriod = 32u;

nsecs periodInNs(Seconds period) {
    if (!(period > 0)) return 0;
    // At least 1 ns, so that it stays periodic, and at most a value that can be added to the current time.
    return std::clamp<nsecs>(Seconds_to_nsecs(period), 1, InfiniteNSecs / 2);
}
}  // namespace

Activity::Activity(base::RunnableInterface* r, const std::string& name)
    : Activity(ORO_SCHED_OTHER, os::LowestPriority, 0.0, 0, r, name) {}
Activity::Activity(int priority, base::RunnableInterface* r, const std::string& name)
    : Activity(ORO_SCHED_RT, priority, 0.0, 0, r, name) {}
Activity::Activity(int priority, Seconds period, base::RunnableInterface* r, const std::string& name)
    : Activity(ORO_SCHED_RT, priority, period, 0, r, name) {}
Activity::Activity(int scheduler, int priority, base::RunnableInterface* r, const std::string& name)
    : Activity(scheduler, priority, 0.0, 0, r, name) {}
Activity::Activity(int scheduler, int priority, Seconds period, base::RunnableInterface* r, const std::string& name)
    : Activity(scheduler, priority, period, 0, r, name) {}

// The os::Thread itself has no period: session() waits for the end of a period and for a wake-up.
Activity::Activity(int scheduler, int priority, Seconds period, unsigned cpuAffinity, base::RunnableInterface* r,
                   const std::string& name)
    : os::Thread(scheduler, priority, cpuAffinity, name, period), updatePeriod_(periodInNs(period)) {
    adopt(r);
}

Activity::Activity(const Options& options, base::RunnableInterface* r)
    : Activity(options.scheduler, options.priority, options.period, options.cpuAffinity, r, options.name) {
    setWaitPeriodPolicy(options.waitPolicy);
    setMaxOverrun(options.maxOverrun);
    setStopTimeout(options.stopTimeout);
}

Activity::~Activity() {
    closeGate();
    stop();
    terminate();
}

bool Activity::run(base::RunnableInterface* r) { return base::ActivityInterface::run(r); }
bool Activity::start() {
    if (isActive() && !isPeriodic()) return trigger();
    if (!os::Thread::start()) return false;
    if (isSelf())  // stopped and started within its session, which continues and would not notice
        wake(kTrigger);
    return true;
}

bool Activity::stop() { return os::Thread::stop(); }
bool Activity::isRunning() const { return isActive() && mayRun(); }
bool Activity::isActive() const { return os::Thread::isActive(); }
bool Activity::isPeriodic() const { return getPeriodNS() != 0; }
Seconds Activity::getPeriod() const { return nsecs_to_Seconds(getPeriodNS()); }
nsecs Activity::getPeriodNS() const { return updatePeriod_; }
unsigned Activity::getCpuAffinity() const { return os::Thread::getCpuAffinity(); }
bool Activity::setCpuAffinity(unsigned cpuAffinity) { return os::Thread::setCpuAffinity(cpuAffinity); }
os::ThreadInterface* Activity::thread() { return this; }
bool Activity::isSelf() const { return os::Thread::isSelf(); }
bool Activity::execute() { return false; }

bool Activity::setPeriod(Seconds period) {
    if (!(period >= 0)) return false;
    updatePeriod_ = periodInNs(period);
    if (isActive()) wake(kNewPeriod | kTrigger);
    return true;
}

bool Activity::trigger() {
    if (!isActive()) return false;
    wake(kTrigger);
    return true;
}

bool Activity::timeout() {
    if (isPeriodic()) return false;
    wake(kTimeout);
    return true;
}

void Activity::session() {
    // The session may begin before start() has posted its reason, so the start counts as a trigger here, and not there.
    constexpr std::uint32_t kOwnReasons = kTrigger | kTimeout | kNewPeriod;
    std::uint32_t reasons = takeEarlyReasons() | kTrigger | kNewPeriod;
    reasons |= waitForWake(0) & kOwnReasons;  // does not wait; takes what the previous session left
    nsecs period = 0;
    nsecs wakeUp = InfiniteNSecs;
    bool starting = true;
    while (mayRun()) {
        if (reasons & kNewPeriod) {
            period = updatePeriod_;
            wakeUp = period > 0 ? rtos_get_time_ns() + period : InfiniteNSecs;
        }
        const nsecs now = period > 0 ? rtos_get_time_ns() : 0;
        if (period == 0) {
            executeTriggered(reasons);
        } else if (now >= wakeUp) {
            wakeUp = nextWakeUp(wakeUp, now, period);
            if (wakeUp == 0) return;
            executePeriod();
        } else if (reasons != 0) {
            executeBetweenPeriods(starting);
        }
        starting = false;
        if (!mayRun()) return;
        reasons = waitForWake(wakeUp);
        // A stop() broke the loop() and then failed: begin the loop() again.
        if ((reasons & kStopReason) && period == 0) reasons |= kTrigger;
        reasons &= kOwnReasons;
    }
}

void Activity::executeTriggered(std::uint32_t reasons) {
    if (reasons & kTimeout) {
        UserCode mark(*this);
        if (!mayRun()) return;
        step();
        work(base::RunnableInterface::TimeOut);
    }
    // Not "else", or a runner with its own loop() would miss the trigger.
    if (reasons & kTrigger) {
        UserCode mark(*this);
        if (!mayRun()) return;
        loop();
        work(base::RunnableInterface::Trigger);
    }
}

void Activity::executePeriod() {
    step();
    work(base::RunnableInterface::TimeOut);
}

void Activity::executeBetweenPeriods(bool starting) {
    if (!starting)  // the first step() is due one period after the start
        step();
    work(base::RunnableInterface::Trigger);
}

bool Activity::initialize() { return claimRunner() && (!runner || runner->initialize()); }

void Activity::step() {
    if (runner) runner->step();
}

void Activity::loop() {
    // A subclass without a runner may have only a step().
    runner ? runner->loop() : step();
}

bool Activity::breakLoop() { return runner ? runner->breakLoop() : os::Thread::breakLoop(); }

void Activity::finalize() {
    if (runner) runner->finalize();
}

void Activity::work(base::RunnableInterface::WorkReason reason) {
    if (runner) runner->work(reason);
}

}  // namespace RTT
