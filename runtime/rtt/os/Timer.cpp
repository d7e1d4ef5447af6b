// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/Timer.hpp>

#include <rtt/Activity.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/os_log.hpp>

namespace RTT::os {

/** Runs Timer::loop(). */
class Timer::OwnActivity : public Activity {
public:
    OwnActivity(Timer& timer, int scheduler, int priority, const std::string& name)
        : Activity(scheduler, priority, 0.0, 0, &timer, name), timer_(timer) {}
    ~OwnActivity() override {
        closeGate();
        stop();
        terminate();
    }

protected:
    // Not a virtual call, because this runs while the sub-class is being constructed. Only timeout() is virtual, and it
    // is not called before a timer is set.
    bool initialize() override { return claimRunner() && timer_.Timer::initialize(); }
    void step() override { timer_.Timer::step(); }
    void loop() override { timer_.Timer::loop(); }
    bool breakLoop() override { return timer_.Timer::breakLoop(); }
    void finalize() override {}
    void work(base::RunnableInterface::WorkReason) override {}

private:
    Timer& timer_;
};

Timer::Timer(TimerId maxTimers, int scheduler, int priority, const std::string& name)
    : timers_(maxTimers > 0 ? static_cast<std::size_t>(maxTimers) : 0) {
    if (scheduler == -1) return;
    own_.reset(new OwnActivity(*this, scheduler, priority, name));
    own_->start();
}

Timer::~Timer() { stopThread(); }

void Timer::stopThread() { own_.reset(); }

void Timer::timeout(TimerId) {}

bool Timer::initialize() {
    MutexLock lock(mutex_);
    quit_ = false;
    return true;
}

void Timer::finalize() {}

bool Timer::breakLoop() {
    MutexLock lock(mutex_);
    quit_ = true;
    changed_.broadcast();
    return true;
}

void Timer::step() {
    TimerId id = 0;
    while (serveExpired(rtos_get_time_ns(), id) > 0) timeout(id);
}

void Timer::loop() {
    for (;;) {
        Timer::step();
        MutexLock lock(mutex_);
        if (leave()) return;
        nsecs earliest = InfiniteNSecs;
        for (const Entry& timer : timers_)
            if (timer.expires != 0 && timer.expires < earliest) earliest = timer.expires;
        if (earliest == InfiniteNSecs)
            changed_.wait(mutex_);
        else if (earliest > rtos_get_time_ns())
            changed_.wait_until(mutex_, earliest);
        if (leave()) return;
    }
}

// True once only: after a stop() that failed because timeout() took too long, there is another loop().
bool Timer::leave() {
    const bool leaves = quit_;
    quit_ = false;
    return leaves;
}

/** Finds the timer that expired first, sets its next expiry and wakes its waiters. Returns 0 if none has expired. */
int Timer::serveExpired(nsecs now, TimerId& expired) {
    MutexLock lock(mutex_);
    Entry* first = nullptr;
    for (Entry& timer : timers_)
        if (timer.expires != 0 && timer.expires <= now && (!first || timer.expires < first->expires)) first = &timer;
    if (!first || quit_) return 0;
    expired = static_cast<TimerId>(first - timers_.data());
    first->expires = first->period != 0 ? first->expires + first->period : 0;
    first->generation = ++changes_;
    expired_.broadcast();
    return 1;
}

void Timer::setMaxTimers(TimerId max) {
    MutexLock lock(mutex_);
    Entry unused;
    unused.generation = ++changes_;
    timers_.resize(max > 0 ? static_cast<std::size_t>(max) : 0, unused);
    expired_.broadcast();
    changed_.broadcast();
}

bool Timer::set(TimerId id, Seconds first, Seconds period) {
    MutexLock lock(mutex_);
    if (!isValid(id)) {
        detail::log(
            detail::LogError, "Timer",
            "invalid timer id " + std::to_string(id) + ", there are " + std::to_string(timers_.size()) + " timers");
        return false;
    }
    Entry& timer = timers_[static_cast<std::size_t>(id)];
    timer.expires = rtos_get_time_ns() + Seconds_to_nsecs(first);
    timer.period = Seconds_to_nsecs(period);
    changed_.broadcast();
    return true;
}

bool Timer::startTimer(TimerId id, Seconds period) {
    if (Seconds_to_nsecs(period) > 0 && period < 9e9) return set(id, period, period);
    detail::log(detail::LogError, "Timer",
                "invalid period for timer " + std::to_string(id) + ", expected seconds above 0 and below 9e9");
    return false;
}

bool Timer::arm(TimerId id, Seconds delay) {
    if (delay >= 0 && delay < 9e9) return set(id, delay, 0.0);
    detail::log(detail::LogError, "Timer",
                "invalid wait time for timer " + std::to_string(id) + ", expected seconds from 0 on and below 9e9");
    return false;
}

bool Timer::isArmed(TimerId id) const {
    MutexLock lock(mutex_);
    return isValid(id) && timers_[static_cast<std::size_t>(id)].expires != 0;
}

Seconds Timer::timeRemaining(TimerId id) const {
    MutexLock lock(mutex_);
    if (!isValid(id) || timers_[static_cast<std::size_t>(id)].expires == 0) return 0.0;
    const nsecs remaining = timers_[static_cast<std::size_t>(id)].expires - rtos_get_time_ns();
    return remaining > 0 ? nsecs_to_Seconds(remaining) : 0.0;
}

bool Timer::killTimer(TimerId id) {
    MutexLock lock(mutex_);
    if (!isValid(id)) {
        detail::log(
            detail::LogError, "Timer",
            "invalid timer id " + std::to_string(id) + ", there are " + std::to_string(timers_.size()) + " timers");
        return false;
    }
    Entry& timer = timers_[static_cast<std::size_t>(id)];
    timer.expires = 0;
    timer.period = 0;
    timer.generation = ++changes_;
    expired_.broadcast();
    return true;
}

bool Timer::waitFor(TimerId id) { return waitForUntil(id, InfiniteNSecs); }

bool Timer::waitForUntil(TimerId id, nsecs deadline) {
    MutexLock lock(mutex_);
    if (!isValid(id) || timers_[static_cast<std::size_t>(id)].expires == 0) return false;
    const unsigned generation = timers_[static_cast<std::size_t>(id)].generation;
    while (isValid(id) && timers_[static_cast<std::size_t>(id)].generation == generation) {
        if (deadline == InfiniteNSecs)
            expired_.wait(mutex_);
        else if (!expired_.wait_until(mutex_, deadline))
            return false;
    }
    return true;
}

}  // namespace RTT::os
