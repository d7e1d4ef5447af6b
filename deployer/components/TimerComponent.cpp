// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/TimerComponent.hpp>

#include <ocl/Component.hpp>
#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/os/Condition.hpp>
#include <rtt/os/Mutex.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/threads.hpp>

#include <cstddef>
#include <vector>

namespace OCL {

using RTT::os::MutexLock;
using RTT::os::Timer;

/** The timers and the ports to which they write. stop() ends its waits, because no timer expires afterwards. */
class TimerComponent::PortTimer : public Timer {
public:
    static constexpr TimerId kPorts = 32;

    explicit PortTimer(RTT::TaskContext& component) : Timer(kPorts) {
        component.addPort("timeout", any_).doc("The number of each timer that expires.");
        for (TimerId id = 0; id < kPorts; ++id)
            component.addPort("timer_" + std::to_string(id), each_[id])
                .doc("Written when timer " + std::to_string(id) + " expires.");
    }

    void timeout(TimerId id) override {
        any_.write(id);
        if (id < kPorts) each_[id].write(id);
        const MutexLock lock(mutex_);
        if (isKnown(id)) ++expiries_[static_cast<std::size_t>(id)];
        changed_.broadcast();
    }

    bool kill(TimerId id) {
        const bool known = Timer::killTimer(id);
        const MutexLock lock(mutex_);
        changed_.broadcast();
        return known;
    }
    void setMax(TimerId timers) {
        Timer::setMaxTimers(timers);
        const MutexLock lock(mutex_);
        if (timers > 0 && !isKnown(timers - 1)) expiries_.resize(static_cast<std::size_t>(timers));
        changed_.broadcast();
    }
    bool waitUntilExpired(TimerId id) {
        const MutexLock lock(mutex_);
        if (!isKnown(id) || !isArmed(id)) return false;
        const std::size_t index = static_cast<std::size_t>(id);
        const unsigned before = expiries_[index];
        bool hasRun = running_;
        while (expiries_[index] == before && isArmed(id) && (running_ || !hasRun)) {
            hasRun = running_;
            if (running_)
                changed_.wait(mutex_);
            else if (!waitForTime(rtos_get_time_ns() + RTT::Seconds_to_nsecs(timeRemaining(id))))
                break;  // its time has come, though no thread lets it expire
        }
        return running_ || !hasRun || expiries_[index] != before;
    }
    /** Waits without arming a timer or writing a port. False for a bad id or delay. */
    bool pause(TimerId id, RTT::Seconds delay) {
        const MutexLock lock(mutex_);
        if (!isKnown(id) || !(delay >= 0 && delay < 9e9)) {
            RTT::log(RTT::Error) << "timer " << id << " cannot wait for " << delay << " s" << RTT::endlog();
            return false;
        }
        const RTT::nsecs end = rtos_get_time_ns() + RTT::Seconds_to_nsecs(delay);
        while (waitForTime(end)) continue;
        return true;
    }
    bool isRunning() {
        const MutexLock lock(mutex_);
        return running_;
    }
    void setRunning(bool running) {
        const MutexLock lock(mutex_);
        running_ = running;
        changed_.broadcast();
    }

private:
    /** Waits until something changes. False if the time `end` has come. */
    bool waitForTime(RTT::nsecs end) {
        if (rtos_get_time_ns() >= end) return false;
        changed_.wait_until(mutex_, end);
        return true;
    }
    bool isKnown(TimerId id) const { return id >= 0 && static_cast<std::size_t>(id) < expiries_.size(); }

    RTT::OutputPort<int> any_;
    RTT::OutputPort<int> each_[kPorts];
    // Locked before the mutex of the timers, which is free when they call timeout().
    RTT::os::Mutex mutex_;
    RTT::os::Condition changed_;
    std::vector<unsigned> expiries_ = std::vector<unsigned>(kPorts);  // number of expiries of each timer
    bool running_ = false;
};

TimerComponent::TimerComponent(std::string name)
    : RTT::TaskContext(name, PreOperational),
      timer_(new PortTimer(*this)),
      thread_(new RTT::Activity(ORO_SCHED_RT, RTT::os::HighestPriority, 0.0, timer_.get(), name + ".Timer")) {
    PortTimer* const timer = timer_.get();
    const char* const id = "timerId";
    const char* const number = "The number of the timer, from 0";
    addOperation("arm", &Timer::arm, timer).doc("Lets a timer expire once.").arg(id, number).arg("delay", "In seconds");
    addOperation("startTimer", &Timer::startTimer, timer)
        .doc("Lets a timer expire again and again.")
        .arg(id, number)
        .arg("period", "In seconds");
    addOperation("killTimer", &PortTimer::kill, timer).doc("Stops a timer.").arg(id, number);
    addOperation("isArmed", &Timer::isArmed, timer).doc("Is a timer going to expire?").arg(id, number);
    addOperation("setMaxTimers", &PortTimer::setMax, timer)
        .doc("Changes the number of timers. Those from 32 on have no port of their own.")
        .arg("timers", "How many; at first there are 32");
    addOperation("waitFor", &PortTimer::waitUntilExpired, timer)
        .doc(
            "Blocks until a timer expires or is killed, or would have expired if the component ran. False if it is not "
            "armed, or stop() came first.")
        .arg(id, number);
    addOperation("wait", &TimerComponent::wait, this)
        .doc(
            "Lets a timer expire once and blocks until then. If the component does not run, it blocks as long, but "
            "nothing expires.")
        .arg(id, number)
        .arg("delay", "In seconds");
}

TimerComponent::~TimerComponent() {
    stopForGood();
    thread_->stop();
}

bool TimerComponent::wait(Timer::TimerId timer, double delay) {
    // Without a thread that lets the timer expire, a script pauses for the same time.
    if (!timer_->isRunning()) return timer_->pause(timer, delay);
    if (!timer_->arm(timer, delay)) return false;
    // If the timer is not armed any more, it has expired already.
    return timer_->waitUntilExpired(timer) || (timer_->isRunning() && !timer_->isArmed(timer));
}

bool TimerComponent::startHook() {
    timer_->setRunning(true);
    if (thread_->start()) return true;
    timer_->setRunning(false);
    return false;
}

void TimerComponent::stopHook() {
    thread_->stop();
    timer_->setRunning(false);
}

}  // namespace OCL

ORO_CREATE_COMPONENT(OCL::TimerComponent)
