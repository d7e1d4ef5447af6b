// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "cycles.hpp"

#include <rtt/ExecutionEngine.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/os/fosi.h>

#include <cmath>
#include <cstdlib>

namespace OCL::chain {
namespace {

using RTT::base::TaskCore;
using RTT::internal::EngineGate;

// No virtual call, because the class of the component may be under destruction.
TaskCore::TaskState stateOf(const RTT::ExecutionEngine& engine) {
    return engine.getTaskCore()->TaskCore::getTaskState();
}

bool isDue(Member& member) {
    if (member.countdown != 0) {
        --member.countdown;
        return false;
    }
    member.countdown = member.divider.every - 1;
    return true;
}

}  // namespace

void Cycles::begin(const ChainStatistics& sample) {
    sample_ = sample;
    statistics.setDataSample(sample_);
    overrun.setDataSample(std::string(128, ' '));
    iteration_.set(0);
    counted_ = nullptr;
    untilReport_ = 0;
    lastTick_ = -1;
    news_ = false;
    lastNews_ = 0;
}

Roster* Cycles::take() {
    Roster* const roster = rosters.take();
    if (roster == counted_ || !roster) return roster;
    counted_ = roster;
    const unsigned now = iteration_();
    for (Member& member : roster->members) {
        const Divider& divider = member.divider;
        member.countdown = (divider.phase + divider.every - now % divider.every) % divider.every;
    }
    return roster;
}

bool Cycles::execute(double period) {
    Roster* const roster = take();
    if (!roster) return true;
    const std::int64_t begin = rtos_get_time_ns();
    lastBegin_ = begin;
    noteBegin(*roster, period);
    const Settings& settings = roster->settings;
    Course course{begin};
    for (Member& member : roster->members) turn(member, settings, course);
    const std::int64_t duration = course.now - begin;
    roster->cycles->durations.add(duration);
    if (settings.budget != 0 && duration > settings.budget) {
        roster->cycles->overruns.add(1);
        overrun.write(name_);
        course.error |= settings.stopOnOverrun;
        news_ = true;
    }
    const unsigned number = iteration_();
    iteration_.set(number + 1);
    count.write(number);
    if (settings.reportEvery != 0 && ++untilReport_ >= settings.reportEvery) {
        untilReport_ = 0;
        report(*roster, period);
    }
    return !course.error;
}

// By the clock of the components, which may be simulated.
void Cycles::noteBegin(Roster& roster, double period) {
    const std::int64_t tick = RTT::os::TimeService::Instance()->getNSecs();
    if (lastTick_ >= 0) {
        roster.periods->add(tick - lastTick_);
        if (period > 0) roster.cycles->jitter.add(std::llabs(tick - lastTick_ - std::llround(period * 1e9)));
    }
    lastTick_ = tick;
}

void Cycles::turn(Member& member, const Settings& settings, Course& course) {
    const bool due = isDue(member);
    const EngineGate::Visit visit(*member.peer.gate);
    const RTT::ExecutionEngine* const engine = visit.engine();
    // A component that has another activity since is in the next roster, or no longer a slave.
    if (!engine || visit.activity() != member.peer.slave) {
        if (due) member.measured->leftOut.add(1);
        return;
    }
    const bool runs = stateOf(*engine) >= TaskCore::Running;
    if (due && runs && !course.cut) return run(member, visit, settings, course);
    if (due) member.measured->leftOut.add(1);
    // A stopped component still executes messages and functions, such as scripts.
    runs ? member.peer.slave->serve() : member.peer.slave->execute();
    course.now = rtos_get_time_ns();
}

void Cycles::run(Member& member, const EngineGate::Visit& visit, const Settings& settings, Course& course) {
    const bool done = member.peer.slave->execute();
    const std::int64_t now = rtos_get_time_ns();
    const std::int64_t duration = now - std::exchange(course.now, now);
    const RTT::ExecutionEngine* const engine = visit.engine();  // null if it was destroyed in its turn
    const TaskCore::TaskState state = engine ? stateOf(*engine) : TaskCore::Stopped;
    const bool threw = state == TaskCore::Exception || state == TaskCore::FatalError;
    if (!done || threw) return fail(member, threw, settings.onError, course);
    Measured& measured = *member.measured;
    measured.times.add(duration);
    if (member.budget == 0 || duration <= member.budget) return;
    measured.overruns.add(1);
    overrun.write(member.peer.name);
    course.error |= settings.stopOnOverrun;
}

void Cycles::fail(Member& member, bool threw, OnError onError, Course& course) {
    member.measured->threw.set(threw);
    member.measured->failures.add(1);
    news_ = true;
    course.cut |= onError != OnError::Skip;
    course.error |= onError == OnError::Stop;
}

void Cycles::serve() {
    Roster* const roster = take();
    if (!roster) return;
    for (const Member& member : roster->members) {
        const EngineGate::Visit visit(*member.peer.gate);
        if (visit.engine() && visit.activity() == member.peer.slave) member.peer.slave->serve();
    }
}

void Cycles::report(const Roster& roster, double period) {
    if (!statistics.connected()) return;
    const MeasuredCycles& cycles = *roster.cycles;
    sample_.iteration = iteration_();
    cycles.durations.read(sample_.cycle);
    cycles.jitter.read(sample_.jitter);
    sample_.utilisation = period > 0 ? sample_.cycle.mean / period : 0;
    sample_.overruns = cycles.overruns();
    sample_.failures = 0;
    for (const Member& member : roster.members) {
        const Measured& measured = *member.measured;
        sample_.failures += measured.failures();
        if (member.row < 0) continue;  // it came after the start
        ChainMember& row = sample_.members[static_cast<std::size_t>(member.row)];
        measured.times.read(row.times);
        row.overruns = measured.overruns();
        row.failures = measured.failures();
        row.left_out = measured.leftOut();
    }
    statistics.write(sample_);
}

}  // namespace OCL::chain
