// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Plugin `rospack`: operation `find` of the global services `ros` and `rospack`.
#include <rtt/Logger.hpp>
#include <rtt/deployment/ros_packages.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/plugin/Plugin.hpp>

namespace {

std::string find(const std::string& package) {
    RTT::plugin::RosPackages packages;
    if (const RTT::plugin::RosPackage* const found = packages.find(package)) return found->directory;
    const std::string problem = packages.problem(package);
    RTT::log(RTT::Warning) << "ros.find: there is no package '" << package << "'"
                           << (problem.empty() ? "; ROS_PACKAGE_PATH and CMAKE_PREFIX_PATH say where packages are"
                                               : ": " + problem)
                           << RTT::endlog();
    return {};
}

}  // namespace

extern "C" {

RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* component) {
    if (component) return false;
    for (const char* const service : {"ros", "rospack"})
        RTT::internal::GlobalService::Instance()
            ->provides(service)
            ->addOperation("find", &find)
            .doc("The folder of a ROS package, or an empty text if there is none of that name.")
            .arg("package", "name of the package");
    return true;
}
RTT_EXPORT std::string getRTTPluginName() { return "rospack"; }
RTT_EXPORT std::string getRTTTargetName() { return OROCOS_TARGET_NAME; }
}
