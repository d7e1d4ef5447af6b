// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "names.hpp"

#include "failure.hpp"

#include <ros/exceptions.h>
#include <ros/init.h>
#include <ros/names.h>

namespace rtt_rosparam {

std::string nameOf(const std::string& component, unsigned policy, const std::string& item) {
    const std::string below = item.empty() ? component : component + '/' + item;
    switch (policy) {
        case RELATIVE: return item;
        case ABSOLUTE: return '/' + item;
        case PRIVATE: return '~' + item;
        case COMPONENT_PRIVATE: return '~' + below;
        case COMPONENT_RELATIVE: return below;
        case COMPONENT_ABSOLUTE: return '/' + below;
        default: break;
    }
    throw Failure(std::to_string(policy) + " is no policy; take RELATIVE (0) to COMPONENT_ABSOLUTE (5)");
}

std::string resolved(const std::string& name) {
    if (!ros::isInitialized())
        throw Failure("parameter '" + name + "': this process is not a ROS node; import rtt_rosnode before, or call " +
                      "ros::init()");
    try {
        const std::string full = ros::names::resolve(name);
        return full.empty() ? "/" : full;  // roscpp takes the end off "/"
    } catch (const ros::InvalidNameException& error) {
        throw Failure("'" + name + "' is not a name for a parameter: " + error.what());
    }
}

}  // namespace rtt_rosparam
