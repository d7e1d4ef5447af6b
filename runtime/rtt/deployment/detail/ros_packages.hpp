// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Finds packages below the directories of ROS_PACKAGE_PATH, in the layout of ROS. ROS itself is not needed.
#ifndef OROFORGE_ROS_PACKAGES_HPP
#define OROFORGE_ROS_PACKAGES_HPP

#include <string>
#include <vector>

namespace RTT::plugin {

struct RosPackage {
    std::string name;
    std::string directory;
};

/** The package and all that it needs at run time, each after those that it needs itself. Packages that are not found
    are left out; without `name`, the list is empty. Reads the file system. */
std::vector<RosPackage> rosPackagesFor(const std::string& name);

}  // namespace RTT::plugin

#endif
