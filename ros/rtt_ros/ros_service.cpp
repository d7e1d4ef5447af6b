// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Plugin `ros`: what the global service `ros` offers without a node. Other packages add to that service.
#include <rtt/internal/GlobalService.hpp>
#include <rtt/plugin/Plugin.hpp>
#include <rtt_ros/rtt_ros.h>

extern "C" {

RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* component) {
    if (component) return false;
    const RTT::Service::shared_ptr ros = RTT::internal::GlobalService::Instance()->provides("ros");
    ros->doc("What concerns ROS.");
    ros->addOperation("import", &rtt_ros::import)
        .doc("Imports a ROS package, after the packages that its package.xml names as plugin_depend.")
        .arg("package", "name of the package");
    return true;
}
RTT_EXPORT std::string getRTTPluginName() { return "ros"; }
RTT_EXPORT std::string getRTTTargetName() { return OROCOS_TARGET_NAME; }
}
