// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_rosclock/detail/clock_topic.hpp>
#include <rtt_rosclock/rtt_rosclock_sim_clock_activity_manager.h>
#include <rtt_rosclock/rtt_rosclock_sim_clock_thread.h>

#include <rtt/Logger.hpp>
#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/os/StartStopManager.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/os/futex.hpp>

#include <exception>
#include <string>

namespace rtt_rosclock {

namespace {

using RTT::nsecs;
using RTT::internal::EngineGate;
using RTT::os::TimeService;

constexpr std::size_t kMostWaiting = 1000;
// Messages and events that lead to others without end must not stop the time.
constexpr int kMostRounds = 100;

std::atomic<bool> isSimulated{false};

bool refuse(const char* what, const std::string& why) {
    RTT::log(RTT::Error) << "rtt_rosclock: " << what << ": " << why << RTT::endlog();
    return false;
}

// Before ROS and the logger end.
const RTT::os::CleanupFunction atExit([] {
    if (isSimulated) SimClockThread::Instance()->disableSim();
});

}  // namespace

boost::shared_ptr<SimClockThread> SimClockThread::Instance() {
    static const boost::shared_ptr<SimClockThread> one(new SimClockThread);
    return one;
}

SimClockThread::SimClockThread()
    : RTT::Activity(ORO_SCHED_OTHER, RTT::os::LowestPriority, nullptr, "rtt_rosclock_SimClockThread"),
      manager_(SimClockActivityManager::Instance()) {
    run(&engine_);
    start();
}

SimClockThread::~SimClockThread() {
    disableSim();
    closeGate();
    stop();
    terminate();
    run(nullptr);
}

bool SimClockThread::setClockSource(ClockSource source) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (enabled_ && source != source_)
        return refuse("cannot change the source of simulated time", "it is enabled; call disableSim() first");
    source_ = source;
    return true;
}

bool SimClockThread::useROSClockTopic() { return setClockSource(SIM_CLOCK_SOURCE_ROS_CLOCK_TOPIC); }
bool SimClockThread::useManualClock() { return setClockSource(SIM_CLOCK_SOURCE_MANUAL); }
bool SimClockThread::simTimeEnabled() { return isSimulated; }

SimClockThread::ClockSource SimClockThread::getClockSource() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return source_;
}

bool SimClockThread::enableSim() {
    const char* const cannot = "cannot enable simulated time";
    const std::lock_guard<std::mutex> one(changing_);
    if (isSimulated) return true;
    const ClockSource source = getClockSource();
    std::shared_ptr<ClockTopic> topic;
    if (source == SIM_CLOCK_SOURCE_ROS_CLOCK_TOPIC) try {
            const std::string why = ClockTopic::whyNot();
            if (!why.empty()) return refuse(cannot, why);
            topic = std::make_shared<ClockTopic>([this] { trigger(); });
        } catch (const std::exception& thrown) {
            return refuse(cannot, std::string("ROS refused the subscription to /clock: ") + thrown.what());
        }
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (source != source_) return refuse(cannot, "another thread has changed its source meanwhile; try again");
        TimeService& time = *TimeService::Instance();
        if (!time.systemClockEnabled())
            return refuse(cannot, "another simulation moves the time; stop it (SimulationThread) first");
        time.enableSystemClock(false);
        time.ticksChange(-time.getTicks());
        logReference_ = RTT::Logger::Instance()->getReferenceTime();
        RTT::Logger::Instance()->setReferenceTime(0);
        topic_ = topic;
        enabled_ = true;
        isSimulated = true;
        ++session_;
    }
    trigger();  // a message may have come already
    return true;
}

bool SimClockThread::disableSim() {
    const std::lock_guard<std::mutex> one(changing_);
    std::shared_ptr<ClockTopic> topic;  // ends after the lock, because that waits for threads of ROS
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!enabled_) return true;
        enabled_ = false;
        isSimulated = false;
        ++session_;
        updates_.clear();
        done_ = asked_;
        topic.swap(topic_);
        TimeService::Release();
        RTT::Logger::Instance()->setReferenceTime(logReference_);
    }
    RTT::os::detail::futexWakeAll(done_);
    return true;
}

bool SimClockThread::updateClock(const ros::Time& time) {
    const char* const cannot = "cannot take a new time";
    std::uint32_t ticket = 0;
    const bool waits = !isSelf();
    bool executed = false;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!enabled_) return refuse(cannot, "simulated time is not enabled; call enableSim() first");
        if (source_ != SIM_CLOCK_SOURCE_MANUAL)
            return refuse(cannot, "it comes from the topic /clock; call disableSim() and useManualClock() first");
        if (updates_.size() >= kMostWaiting)
            return refuse(cannot, std::to_string(updates_.size()) + " earlier ones wait for the thread of the simulation");
        updates_.push_back({static_cast<nsecs>(time.toNSec()), waits ? &executed : nullptr});
        ticket = ++asked_;
    }
    trigger();
    if (!waits) return true;
    for (std::uint32_t done = done_; static_cast<std::int32_t>(done - ticket) < 0; done = done_)
        EngineGate::sleepOn(done_, done);
    const std::lock_guard<std::mutex> lock(mutex_);
    return executed;
}

bool SimClockThread::breakLoop() { return true; }

void SimClockThread::loop() {
    manager_->repeatMissedTriggers();
    pollTopic();
    Update update{};
    for (std::uint32_t session = 0; mayRun() && nextUpdate(update, session); pollTopic()) {
        advance(update.time, session);
        finished(update, session);
    }
}

void SimClockThread::pollTopic() {
    std::shared_ptr<ClockTopic> topic;
    std::uint32_t session = 0;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        topic = topic_;
        session = session_;
    }
    long long time = 0;
    if (!topic || !topic->poll(time)) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (session != session_) return;
    updates_.push_back({time, nullptr});
    ++asked_;
}

bool SimClockThread::nextUpdate(Update& update, std::uint32_t& session) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (updates_.empty()) return false;
    update = updates_.front();
    updates_.pop_front();
    session = session_;
    return true;
}

void SimClockThread::finished(const Update& update, std::uint32_t session) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (session != session_) return;
        if (update.executed) *update.executed = true;
        ++done_;
    }
    RTT::os::detail::futexWakeAll(done_);
}

bool SimClockThread::moveTime(nsecs to, std::uint32_t session) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (session != session_) return false;
    TimeService& time = *TimeService::Instance();
    const TimeService::ticks by = TimeService::nsecs2ticks(to) - time.getTicks();
    manager_->setSimulationPeriod(RTT::nsecs_to_Seconds(TimeService::ticks2nsecs(by)));
    time.ticksChange(by);
    return true;
}

void SimClockThread::advance(nsecs to, std::uint32_t session) {
    if (session != startedSession_) {
        startedSession_ = session;
        isFirst_ = true;
        manager_->reset(0);
    }
    const nsecs from = manager_->now();
    if (to == from) return;
    const bool isBack = to < from;
    if (isBack && to != 0)
        RTT::log(RTT::Warning) << "rtt_rosclock: simulated time moves back from " << RTT::nsecs_to_Seconds(from) << " s to "
                               << RTT::nsecs_to_Seconds(to) << " s; due times are set anew" << RTT::endlog();
    if (isBack) {
        if (!moveTime(to, session)) return;
        isFirst_ = to == 0;
        manager_->reset(to);
        if (to != 0) executeDue(to, true, session);
        return settle();
    }
    const nsecs missed = manager_->mostMissed(to);
    const bool isJump = missed > SimClockActivityManager::kMostMissed;
    // Simulated time that is enabled late begins with such a time.
    if (isJump && !isFirst_)
        RTT::log(RTT::Warning) << "rtt_rosclock: simulated time jumps from " << RTT::nsecs_to_Seconds(from) << " s to "
                               << RTT::nsecs_to_Seconds(to) << " s; what is due executes once, not up to " << missed
                               << " times" << RTT::endlog();
    isFirst_ = false;
    for (nsecs at = 0; at != to && mayRun();) {
        at = isJump ? to : manager_->nextDue(to);
        if (!moveTime(at, session)) return;
        executeDue(at, at == to, session);
        settle();
    }
}

// In a step of the engine: while an activity waits for another component, the thread serves the other activities.
void SimClockThread::executeDue(nsecs now, bool isClockTime, std::uint32_t session) {
    const EngineGate::Step here(*engine_.gate());
    manager_->execute(now, isClockTime, [&] { return session == session_; });
}

// What the executions have sent is executed before the time moves on, so that the order does not depend on other threads.
void SimClockThread::settle() {
    for (int round = 0; round != kMostRounds; ++round) {
        manager_->repeatMissedTriggers();
        if (!engine_.hasWork()) return;
        work(RTT::base::RunnableInterface::Trigger);
    }
}

}  // namespace rtt_rosclock
