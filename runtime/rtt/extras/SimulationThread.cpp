// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/extras/SimulationThread.hpp>

#include <rtt/os/TimeService.hpp>

namespace RTT::extras {

namespace {

struct Instances {
    std::mutex mutex;
    SimulationThreadPtr one;
};

// Destroyed at the end of the process, so that the thread does not execute activities that are gone.
Instances& instances() {
    static Instances all;
    return all;
}

constexpr double kDefaultPeriod = 0.001;

}  // namespace

SimulationThread::SimulationThread(int priority, const std::string& name, double period)
    : TimerThread(ORO_SCHED_OTHER, priority, name, period > 0 ? period : kDefaultPeriod) {}

SimulationThread::~SimulationThread() {
    stop();
    terminate();
}

SimulationThreadPtr SimulationThread::Instance(double period) {
    Instances& all = instances();
    std::lock_guard<std::mutex> lock(all.mutex);
    if (!all.one) all.one.reset(new SimulationThread(os::LowestPriority, "SimulationThread", period));
    return all.one;
}

bool SimulationThread::Release() {
    SimulationThreadPtr last;  // destroyed after the lock is released, because that may wait for a step
    std::lock_guard<std::mutex> lock(instances().mutex);
    last.swap(instances().one);
    return last != nullptr;
}

bool SimulationThread::startLimited(unsigned maxSteps) {
    std::lock_guard<std::mutex> lock(mode_);
    if (inRun_ || TimerThread::isActive()) return false;
    maxSteps_ = maxSteps;
    return TimerThread::start();
}

bool SimulationThread::start() { return startLimited(0); }
bool SimulationThread::start(unsigned maxSteps) { return maxSteps != 0 && startLimited(maxSteps); }

bool SimulationThread::run(unsigned maxSteps) {
    if (maxSteps == 0) return false;
    {
        std::lock_guard<std::mutex> lock(mode_);
        if (inRun_ || TimerThread::isActive()) return false;
        leaveRun_ = false;
        inRun_ = true;
    }
    initialize();
    maxSteps_ = 0;
    for (unsigned made = 0; made < maxSteps && !leaveRun_; ++made) step();
    finalize();
    inRun_ = false;
    return true;
}

bool SimulationThread::stop() {
    if (!inRun_) return TimerThread::stop();
    leaveRun_ = true;
    return true;
}

bool SimulationThread::isRunning() const { return inRun_ || TimerThread::isRunning(); }
bool SimulationThread::isActive() const { return inRun_ || TimerThread::isActive(); }

bool SimulationThread::initialize() {
    steps_ = 0;
    os::TimeService::Instance()->enableSystemClock(false);
    return true;
}

void SimulationThread::step() {
    TimerThread::step();
    os::TimeService::Instance()->ticksChange(os::TimeService::nsecs2ticks(getPeriodNS()));
    if (maxSteps_ != 0 && ++steps_ >= maxSteps_) stop();
}

void SimulationThread::finalize() { os::TimeService::Instance()->enableSystemClock(true); }

}  // namespace RTT::extras
