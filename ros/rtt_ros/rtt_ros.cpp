// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_ros/rtt_ros.h>

#include <rtt/Logger.hpp>
#include <rtt/deployment/ComponentLoader.hpp>

namespace rtt_ros {

bool import(const std::string& package) {
    const RTT::Logger::In in("rtt_ros::import");
    std::string error;
    if (RTT::ComponentLoader::Instance()->importRos(package, error)) return true;
    RTT::log(RTT::Warning) << "could not import all of ROS package '" << package << "': " << error << RTT::endlog();
    return false;
}

}  // namespace rtt_ros
