// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Time of ROS and of the runtime, and simulated time. Every function may be called by any thread. A header of roscpp is
/// used, but ROS need not be initialised.
#ifndef RTT_ROSCLOCK_RTT_ROSCLOCK_H
#define RTT_ROSCLOCK_RTT_ROSCLOCK_H

#include <rtt/Time.hpp>

#include <ros/time.h>

namespace RTT {
class TaskContext;
}

namespace rtt_rosclock {

/// Simulated time while it is enabled, otherwise ros::Time::now(); without ROS the time of the system. Real-time safe
/// while simulated time is enabled.
const ros::Time host_now();
/// The time of the system (ros::WallTime), simulated or not. Real-time safe.
const ros::Time host_wall_now();
/// The time of RTT::os::TimeService: simulated time while it is enabled, otherwise the monotonic clock. Real-time safe.
const ros::Time rtt_now();
/// The monotonic clock of the runtime, simulated or not. Real-time safe.
const ros::Time rtt_wall_now();
/// host_wall_now() - rtt_wall_now(): what to add to a time of the monotonic clock. Real-time safe.
RTT::Seconds host_offset_from_rtt();

/// Gives a component a SimClockActivity of its present period; true also if it has one. False, with an error logged, if
/// the component is running. Blocks until the former activity has ended.
bool set_sim_clock_activity(RTT::TaskContext* component);

/// Simulated time comes from the topic /clock. False, with an error logged, while simulated time is enabled. The source
/// is manual at first.
bool use_ros_clock_topic();
/// Simulated time comes from update_sim_clock(). False, with an error logged, while simulated time is enabled.
bool use_manual_clock();

/// Sets the time of RTT::os::TimeService to 0; from then on only the source moves it. True if it is enabled already.
/// False, with an error logged: for the source /clock if there is no node or if the parameter /use_sim_time is not true,
/// and for any source if another simulation has taken the time. Blocks while it asks the ROS master, which is given up
/// after 2 s.
bool enable_sim();
/// The time is that of the system again. An execution in progress is not waited for; no further one begins. True also if
/// it was not enabled. For the source /clock, blocks while the ROS master is told, 2 s at most.
bool disable_sim();

/// An activity that is due more often than this in one step of the clock executes once, at the end of the step; others
/// execute at each of their due times. 1000 at first. False, with an error logged, if negative. Real-time safe otherwise.
bool set_catch_up_limit(int executions);
int catch_up_limit();

/// The new time of a manual clock. Executes what is due up to that time in the thread of the simulation, and blocks until
/// that is done; the calling component serves its messages meanwhile. If the thread of the simulation calls it, the time
/// follows after the present one and this returns at once. What an execution waits for must not call it. Equal times do
/// nothing, an earlier one moves back, 0 resets. False, with an error logged, if a manual clock is not enabled; false if
/// it is disabled, or the thread of the simulation stopped, meanwhile.
bool update_sim_clock(const ros::Time& new_time);

}  // namespace rtt_rosclock

#endif
