// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROS_RTT_ROS_H
#define RTT_ROS_RTT_ROS_H

#include <string>

namespace rtt_ros {

/**
 * Imports a ROS package with its plugins, typekits and components, after the packages that its package.xml (or
 * manifest.xml) names in `<export><rtt_ros><plugin_depend>`, and those of these. Each is imported once; a package that
 * is imported already, or has no libraries, is no failure. Packages are found below ROS_PACKAGE_PATH, CMAKE_PREFIX_PATH
 * and the toolchain's installation. ROS need not run.
 *
 * False, with the reasons in the log, if anything could not be imported; the rest is imported all the same. Any thread
 * may call it; it reads files and is not real-time. The operation `ros.import` of scripts is this function.
 */
bool import(const std::string& package);

}  // namespace rtt_ros

#endif
