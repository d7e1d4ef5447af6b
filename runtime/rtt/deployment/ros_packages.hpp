// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ROS_PACKAGES_HPP
#define ORO_ROS_PACKAGES_HPP

#include <rtt/rtt-config.h>

#include <memory>
#include <string>
#include <vector>

namespace RTT::plugin {

/** A package of ROS, as its package.xml (catkin, ament) or manifest.xml (rosbuild) describes it. */
struct RosPackage {
    std::string name;
    std::string directory;                  // that of the file
    std::vector<std::string> dependencies;  // at run time
    std::vector<std::string> plugins;       // export/rtt_ros/plugin_depend: what rtt_ros::import() brings with it
};

/**
 * Finds packages of ROS; ROS itself is not needed. It searches below the directories of ROS_PACKAGE_PATH, then in
 * `share` of each directory of CMAKE_PREFIX_PATH, of the toolchain's installation, and of /usr; the first package of a
 * name is taken. Packages of a directory named `share` are directly in it, and named as their folders.
 *
 * An object keeps what it has read. One thread at a time may use it; it reads the file system.
 */
class RTT_API RosPackages {
public:
    /** Takes the search path from the environment. */
    RosPackages();
    ~RosPackages();
    RosPackages(const RosPackages&) = delete;
    RosPackages& operator=(const RosPackages&) = delete;

    /** Null if there is none of that name. Valid as long as this object. */
    const RosPackage* find(const std::string& name);

    /** The package and all that it needs at run time, each after those that it needs itself. Those that are not found
        are left out; without `name`, the list is empty. */
    std::vector<RosPackage> withDependencies(const std::string& name);

    /** Why the file of a package of that name, or in a folder of that name, is not used: "<file>:<line>:<column>:
        error: …". Empty if no such file is faulty. */
    std::string problem(const std::string& name) const;

    /** Where libraries of the package may be: search paths of components, those of its own source folder first if it is
        a rosbuild package. */
    std::vector<std::string> libraryPaths(const RosPackage& package) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace RTT::plugin

#endif
