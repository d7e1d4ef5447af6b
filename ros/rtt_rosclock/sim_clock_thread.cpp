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

#include <cxxabi.h>
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
    if (isSimulated) return true;
    const ClockSource source = getClockSource();
    // Begins before the lock, and ends after it, because ROS asks the master.
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
        if (enabled_) return true;
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
    std::shared_ptr<ClockTopic> topic;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!enabled_) return true;
        enabled_ = false;
        isSimulated = false;
        ++session_;
        dropUpdates();
        topic.swap(topic_);
        TimeService::Release();
        RTT::Logger::Instance()->setReferenceTime(logReference_);
    }
    if (topic) topic->close();
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
        if (!takesUpdates_) return refuse(cannot, "the thread of the simulation is stopped; start() it");
        push(static_cast<nsecs>(time.toNSec()), waits ? &executed : nullptr);
        ticket = asked_;
    }
    trigger();
    if (!waits) return true;
    for (std::uint32_t done = done_; static_cast<std::int32_t>(done - ticket) < 0; done = done_)
        EngineGate::sleepOn(done_, done);
    const std::lock_guard<std::mutex> lock(mutex_);
    return executed;
}

// With the mutex.
void SimClockThread::push(nsecs time, bool* executed) {
    updates_.push_back({time, executed, asked_ + 1});
    ++asked_;
}

// With the mutex. One that is executing counts as done, so finished() does nothing for it.
void SimClockThread::dropUpdates() {
    updates_.clear();
    done_ = asked_;
    RTT::os::detail::futexWakeAll(done_);
}

bool SimClockThread::initialize() {
    if (!RTT::Activity::initialize()) return false;
    const std::lock_guard<std::mutex> lock(mutex_);
    takesUpdates_ = true;
    return true;
}

bool SimClockThread::breakLoop() { return true; }

void SimClockThread::finalize() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        takesUpdates_ = false;
        dropUpdates();
    }
    RTT::Activity::finalize();
}

// What activities throw, they catch; a class that is derived from one may not.
void SimClockThread::work(RTT::base::RunnableInterface::WorkReason reason) {
    try {
        RTT::Activity::work(reason);
    } catch (abi::__forced_unwind&) {
        throw;
    } catch (const std::exception& thrown) {
        RTT::log(RTT::Critical) << "rtt_rosclock: an exception left a message to an activity: " << thrown.what()
                                << RTT::endlog();
    } catch (...) {
        RTT::log(RTT::Critical) << "rtt_rosclock: an exception of unknown type left a message to an activity"
                                << RTT::endlog();
    }
}

void SimClockThread::loop() {
    manager_->repeatMissedTriggers();
    pollTopic();
    Update update{};
    for (std::uint32_t session = 0; mayRun() && nextUpdate(update, session); pollTopic()) {
        const bool reached = advance(update.time, session);
        finished(update, reached);
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
    if (session == session_ && takesUpdates_) push(time, nullptr);
}

bool SimClockThread::nextUpdate(Update& update, std::uint32_t& session) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (updates_.empty()) return false;
    update = updates_.front();
    updates_.pop_front();
    session = session_;
    return true;
}

void SimClockThread::finished(const Update& update, bool reached) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (static_cast<std::int32_t>(done_ - update.ticket) >= 0) return;  // dropped: nobody waits for it
    if (update.executed) *update.executed = reached;
    done_ = update.ticket;
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

// False if it has not come to that time, because the simulation or its thread has been stopped meanwhile.
bool SimClockThread::advance(nsecs to, std::uint32_t session) {
    if (session != startedSession_) {
        startedSession_ = session;
        isFirst_ = true;
        hasWarned_ = false;
        manager_->reset(0);
    }
    const nsecs from = manager_->now();
    if (to < from) return moveBack(to, session);
    manager_->beginStep();
    for (nsecs at = from; at != to;) {
        if (!mayRun()) return false;
        at = manager_->nextDue(to);
        if (!moveTime(at, session)) return false;
        executeDue(at, at == to, session);
        settle();
    }
    if (to != from) warnOfSkips(from, to);
    return true;
}

bool SimClockThread::moveBack(nsecs to, std::uint32_t session) {
    if (to != 0)
        RTT::log(RTT::Warning) << "rtt_rosclock: simulated time moves back from " << RTT::nsecs_to_Seconds(manager_->now())
                               << " s to " << RTT::nsecs_to_Seconds(to) << " s; due times are set anew" << RTT::endlog();
    if (!moveTime(to, session)) return false;
    isFirst_ = to == 0;
    manager_->reset(to);
    if (to != 0) executeDue(to, true, session);
    settle();
    return true;
}

void SimClockThread::warnOfSkips(nsecs from, nsecs to) {
    const auto& skips = manager_->skips();
    // Simulated time that is enabled late begins with such a step.
    if (skips.activities != 0 && !isFirst_ && !hasWarned_)
        RTT::log(RTT::Warning) << "rtt_rosclock: in the step of simulated time from " << RTT::nsecs_to_Seconds(from)
                               << " s to " << RTT::nsecs_to_Seconds(to) << " s, '" << skips.busiest << "' was due "
                               << skips.most << " times, more than the limit of " << manager_->catchUpLimit()
                               << ", and has executed once, as " << skips.activities - 1
                               << " others have; setCatchUpLimit() changes the limit. No warning of the steps that follow "
                                  "until one is within the limit"
                               << RTT::endlog();
    hasWarned_ = skips.activities != 0 && !isFirst_;
    isFirst_ = false;
}

// In a step of the engine: while an activity waits for another component, the thread serves the other activities.
void SimClockThread::executeDue(nsecs now, bool isClockTime, std::uint32_t session) {
    const EngineGate::Step here(*engine_.gate());
    manager_->execute(now, isClockTime, true, [&] { return session == session_; });
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
