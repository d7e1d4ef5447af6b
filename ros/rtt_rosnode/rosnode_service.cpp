// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Plugin `rosnode`: makes the process a ROS node; operations `getNodeName` and `getNamespace` of the global service
// `ros`.
#include <rtt/internal/GlobalService.hpp>
#include <rtt/os/StartStopManager.hpp>
#include <rtt/plugin/Plugin.hpp>
#include <rtt_ros/node.hpp>

#include <ros/init.h>
#include <ros/this_node.h>

namespace {

std::string nodeName() { return ros::isInitialized() ? ros::this_node::getName() : ""; }
std::string nodeNamespace() { return ros::isInitialized() ? ros::this_node::getNamespace() : ""; }

// Components have been destroyed by then, and plugins are still there.
const RTT::os::CleanupFunction atExit(&rtt_ros::stopNode, RTT::os::StopDefault);

}  // namespace

extern "C" {

RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* component) {
    if (component) return false;
    const RTT::Service::shared_ptr ros = RTT::internal::GlobalService::Instance()->provides("ros");
    ros->addOperation("getNodeName", &nodeName)
        .doc("The resolved name of the ROS node of this process, or an empty text if it is none.");
    ros->addOperation("getNamespace", &nodeNamespace).doc("The namespace of the ROS node of this process.");
    return rtt_ros::startNode();
}
/** The master that was not there at first may be there now. */
RTT_EXPORT void onRTTPluginImportedAgain() { (void)rtt_ros::startNode(); }
RTT_EXPORT std::string getRTTPluginName() { return "rosnode"; }
RTT_EXPORT std::string getRTTTargetName() { return OROCOS_TARGET_NAME; }
}
