// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Packages below the directories of ROS_PACKAGE_PATH, as ROS lays them out. ROS itself is not needed.
#ifndef OROFORGE_ROS_PACKAGES_HPP
#define OROFORGE_ROS_PACKAGES_HPP

#include <string>
#include <vector>

namespace RTT::plugin {

struct RosPackage {
    std::string name;
    std::string directory;
};

/** The package and those it needs at run time, directly or not; each after those it needs. Only packages that are found, so
    nothing if `name` is not. Reads the file system. */
std::vector<RosPackage> rosPackagesFor(const std::string& name);

}  // namespace RTT::plugin

#endif
