// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Programs of the toolchain as nodes of ROS.
#ifndef OROFORGE_TESTS_ROS_NODE_PROGRAMS_HPP
#define OROFORGE_TESTS_ROS_NODE_PROGRAMS_HPP

#include <chrono>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <support/child_process.hpp>
#include <support/ros_master.hpp>
#include <support/temp_dir.hpp>

namespace ros_node_test {

inline const std::string kPrefix = ROS_NODE_PREFIX;

/// The environment in which roslaunch and rosrun find the packages of the toolchain.
inline void useToolchain() {
    setenv("ROS_PACKAGE_PATH", (kPrefix + "/share").c_str(), 1);
    setenv("CMAKE_PREFIX_PATH", kPrefix.c_str(), 1);
    setenv("PYTHONPATH", (kPrefix + "/lib/python3/dist-packages").c_str(), 1);
    setenv("OROCOS_TARGET", OROCOS_TARGET_NAME, 1);
    unsetenv("RTT_COMPONENT_PATH");
}

/// A program of the toolchain that needs no terminal.
inline oroforge::test::Command program(const std::string& name, const std::vector<std::string>& arguments,
                                       const oroforge::test::TempDir& folder) {
    oroforge::test::Command command;
    command.program = kPrefix + "/bin/" + name + "-" OROCOS_TARGET_NAME;
    command.arguments = arguments;
    command.directory = folder.path();
    command.environment = {{"ORO_NO_CONSOLE", "1"}};
    command.timeout = std::chrono::seconds(30);
    return command;
}

/// True as soon as the condition is.
inline bool becomes(const std::function<bool()>& condition, std::chrono::seconds limit = std::chrono::seconds(10)) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return true;
}

}  // namespace ros_node_test

#endif
