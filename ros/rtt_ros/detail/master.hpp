// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROS_DETAIL_MASTER_HPP
#define RTT_ROS_DETAIL_MASTER_HPP

#include <chrono>
#include <string>

namespace rtt_ros::detail {

// A socket of its own, not callXmlRpc(): the client of roscpp waits for a name server without a limit.
/** Empty if the ROS master at host and port answers a call within the time; otherwise, why not. Unlike
    ros::master::check(), it never waits longer: for a name server, a host that is off, or a master that hangs. */
std::string whyMasterIsSilent(const std::string& host, unsigned port, std::chrono::milliseconds limit);

}  // namespace rtt_ros::detail

#endif
