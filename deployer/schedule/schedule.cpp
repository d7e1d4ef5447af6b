// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "schedule.hpp"

#include "agenda.hpp"
#include "scheduled_activity.hpp"

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/os/fosi.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

namespace OCL::schedule {
namespace {

using RTT::os::TimeService;

RTT::nsecs now() { return TimeService::Instance()->getNSecs(); }

void setTime(RTT::nsecs time) {
    TimeService& service = *TimeService::Instance();
    (void)service.ticksChange(TimeService::nsecs2ticks(time) - service.getTicks());
}

}  // namespace

Schedule::Schedule(RTT::nsecs start)
    : agenda_(std::make_shared<Agenda>()), isFirst_(TimeService::Instance()->systemClockEnabled()) {
    TimeService::Instance()->enableSystemClock(false);
    setTime(start);
    // Lines of the log begin with the seconds since then.
    RTT::Logger::Instance()->setReferenceTime(TimeService::Instance()->getTicks());
    RTT::internal::GlobalEngine::Release();  // its thread, if there is one
    RTT::internal::OtherOrder::install(agenda_.get());
}

Schedule::~Schedule() {
    std::string error;
    (void)settle(error);
    RTT::internal::GlobalEngine::Release();
    RTT::internal::OtherOrder::install(nullptr);
    if (isFirst_) (void)TimeService::Release();
}

Schedule::Outcome Schedule::run(replay::TimedSource& source, const std::function<bool()>& interrupted) {
    Outcome outcome;
    start_ = now();
    wallStart_ = rtos_get_time_ns();
    const unsigned long before = agenda_->executions();
    agenda_->countStrangers();
    bool good = settle(outcome.error);
    while (good && !interrupted()) {
        const std::optional<RTT::nsecs> next = source.next();
        if (!next) {
            outcome.isComplete = true;
            break;
        }
        const RTT::nsecs time = std::min(*next, agenda_->nextDue().value_or(*next));
        moveTo(time, interrupted);
        agenda_->executeDue(time);
        if (*next <= time) source.deliver();
        good = settle(outcome.error);
    }
    outcome.simulated = now() - start_;
    outcome.executions = agenda_->executions() - before;
    return outcome;
}

void Schedule::moveTo(RTT::nsecs time, const std::function<bool()>& interrupted) {
    if (speed_ > 0) {
        constexpr std::int64_t kLook = 20000000;
        const auto due = wallStart_ + static_cast<std::int64_t>(static_cast<double>(time - start_) / speed_);
        for (std::int64_t left = due - rtos_get_time_ns(); left > 0 && !interrupted(); left = due - rtos_get_time_ns())
            std::this_thread::sleep_for(std::chrono::nanoseconds(std::min(left, kLook)));
    }
    if (time > now()) setTime(time);
}

bool Schedule::settle(std::string& error) {
    agenda_->takeForeign();  // once: a thread that triggers again and again does not keep the time from going on
    for (unsigned long count = 0; agenda_->executeTriggered() || agenda_->executeLastOne(); ++count) {
        if (count < kMostAtOnce) continue;
        error = endless();
        return false;
    }
    return true;
}

std::string Schedule::endless() {
    constexpr unsigned kRounds = 1000;
    std::set<std::string> names;
    for (unsigned i = 0; i != kRounds && agenda_->executeTriggered(); ++i) names.insert(agenda_->lastExecuted());
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "'" : ", '") + name + "'";
    return "the replay ends: " + std::string(names.size() == 1 ? "component " : "components ") + list +
           (names.size() == 1 ? " triggers itself" : " trigger each other") +
           " again and again, and time cannot go on; give " + (names.size() == 1 ? "it" : "one of them") + " a period";
}

void Schedule::executeLast(RTT::TaskContext& component) {
    if (auto* const activity = dynamic_cast<ScheduledActivity*>(component.getActivity()))
        agenda_->executeLast(*activity);
}

std::set<std::string> Schedule::ownThreads() const { return agenda_->ownThreads(); }
std::map<std::string, unsigned long> Schedule::triggeredByOthers() const { return agenda_->strangers(); }

}  // namespace OCL::schedule
