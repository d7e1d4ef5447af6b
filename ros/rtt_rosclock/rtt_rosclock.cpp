// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_rosclock/rtt_rosclock.h>
#include <rtt_rosclock/rtt_rosclock_sim_clock_activity.h>
#include <rtt_rosclock/rtt_rosclock_sim_clock_activity_manager.h>
#include <rtt_rosclock/rtt_rosclock_sim_clock_thread.h>

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/TimeService.hpp>

#include <algorithm>

namespace rtt_rosclock {

namespace {

using RTT::nsecs;
using RTT::os::TimeService;

// Times before 0 and after 2106 cannot be expressed.
ros::Time toRos(nsecs time) {
    return ros::Time().fromNSec(static_cast<uint64_t>(std::clamp<nsecs>(time, 0, 4294967295999999999)));
}

nsecs hostWall() { return static_cast<nsecs>(ros::WallTime::now().toNSec()); }
nsecs rttWall() { return TimeService::ticks2nsecs(rtos_get_time_ticks()); }

}  // namespace

const ros::Time host_now() {
    if (SimClockThread::simTimeEnabled()) return rtt_now();
    try {
        return ros::Time::now();
    } catch (const ros::TimeNotInitializedException&) {
        return host_wall_now();
    }
}

const ros::Time host_wall_now() { return toRos(hostWall()); }
const ros::Time rtt_now() { return toRos(TimeService::Instance()->getNSecs()); }
const ros::Time rtt_wall_now() { return toRos(rttWall()); }
RTT::Seconds host_offset_from_rtt() { return RTT::nsecs_to_Seconds(hostWall() - rttWall()); }

bool set_sim_clock_activity(RTT::TaskContext* component) {
    if (!component) {
        RTT::log(RTT::Error) << "rtt_rosclock: cannot set the activity of no component" << RTT::endlog();
        return false;
    }
    if (dynamic_cast<SimClockActivity*>(component->getActivity())) return true;
    return component->setActivity(new SimClockActivity(component->getPeriod(), nullptr, component->getName()));
}

bool use_ros_clock_topic() { return SimClockThread::Instance()->useROSClockTopic(); }
bool use_manual_clock() { return SimClockThread::Instance()->useManualClock(); }
bool enable_sim() { return SimClockThread::Instance()->enableSim(); }
bool disable_sim() { return SimClockThread::Instance()->disableSim(); }
bool set_catch_up_limit(int executions) {
    if (executions < 0) {
        RTT::log(RTT::Error) << "rtt_rosclock: the limit of executions in a step cannot be " << executions
                             << "; expected 0 or more" << RTT::endlog();
        return false;
    }
    SimClockActivityManager::Instance()->setCatchUpLimit(executions);
    return true;
}
int catch_up_limit() { return SimClockActivityManager::Instance()->catchUpLimit(); }
bool update_sim_clock(const ros::Time& new_time) { return SimClockThread::Instance()->updateClock(new_time); }

}  // namespace rtt_rosclock
