// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/TimerComponent.hpp>

#include <ocl/Component.hpp>
#include <rtt/Activity.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/os/threads.hpp>

namespace OCL {

using RTT::os::Timer;

/** The timers, and the ports that they write to. */
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
    }

private:
    RTT::OutputPort<int> any_;
    RTT::OutputPort<int> each_[kPorts];
};

TimerComponent::TimerComponent(std::string name)
    : RTT::TaskContext(name, PreOperational),
      timer_(new PortTimer(*this)),
      thread_(new RTT::Activity(ORO_SCHED_RT, RTT::os::HighestPriority, 0.0, timer_.get(), name + ".Timer")) {
    Timer* const timer = timer_.get();
    const char* const id = "timerId";
    const char* const number = "The number of the timer, from 0";
    addOperation("arm", &Timer::arm, timer).doc("Lets a timer expire once.").arg(id, number).arg("delay", "In seconds");
    addOperation("startTimer", &Timer::startTimer, timer)
        .doc("Lets a timer expire again and again.")
        .arg(id, number)
        .arg("period", "In seconds");
    addOperation("killTimer", &Timer::killTimer, timer).doc("Stops a timer.").arg(id, number);
    addOperation("isArmed", &Timer::isArmed, timer).doc("Whether a timer is going to expire.").arg(id, number);
    addOperation("setMaxTimers", &Timer::setMaxTimers, timer)
        .doc("Changes the number of timers. Those from 32 on have no port of their own.")
        .arg("timers", "How many; at first there are 32");
    addOperation("waitFor", &Timer::waitFor, timer)
        .doc("Blocks until a timer expires or is killed; false if it is not armed.")
        .arg(id, number);
    addOperation("wait", &TimerComponent::wait, this)
        .doc("Lets a timer expire once and blocks until then.")
        .arg(id, number)
        .arg("delay", "In seconds");
}

TimerComponent::~TimerComponent() {
    stop();
    thread_->stop();
}

bool TimerComponent::wait(Timer::TimerId timer, double delay) {
    if (!timer_->arm(timer, delay)) return false;
    (void)timer_->waitFor(timer);  // false if it has expired by now: then there is nothing to wait for
    return true;
}

bool TimerComponent::startHook() { return thread_->start(); }

void TimerComponent::stopHook() { thread_->stop(); }

}  // namespace OCL

ORO_CREATE_COMPONENT(OCL::TimerComponent)
