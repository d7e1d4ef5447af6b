// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_actionlib/status_timer.hpp>

#include <ros/exception.h>
#include <rtt/DataFlowInterface.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/PortInterface.hpp>

#include <utility>

namespace rtt_actionlib {

ros::Time now() {
    try {
        return ros::Time::now();
    } catch (const ros::Exception&) {
        ros::Time::init();
        return ros::Time::now();
    }
}

namespace {

RTT::Activity::Options optionsOf(const std::string& name, RTT::Seconds period, int scheduler) {
    RTT::Activity::Options options;
    options.name = name;
    options.scheduler = scheduler;
    options.priority = RTT::os::LowestPriority;
    options.period = period > 0 ? period : 0.2;
    return options;
}

}  // namespace

StatusTimer::StatusTimer(const std::string& name, RTT::Seconds period, int scheduler, std::function<void()> tick)
    : RTT::Activity(optionsOf(name, period, scheduler)), tick_(std::move(tick)) {}

StatusTimer::~StatusTimer() { (void)stop(); }

void StatusTimer::step() { tick_(); }

void MissedSamples::tellOnce(RTT::base::PortInterface& first, RTT::base::PortInterface& second) {
    RTT::DataFlowInterface* const ports = first.getInterface();
    const RTT::TaskContext* const owner = ports ? ports->getOwner() : nullptr;
    const bool isRunning = owner && owner->isRunning();
    if (isRunning && !wasRunning_) {
        ports->dataOnPort(&first);
        ports->dataOnPort(&second);
    }
    wasRunning_ = isRunning;
}

}  // namespace rtt_actionlib
