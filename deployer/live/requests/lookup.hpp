// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Finds what a path means, as the console does, in components that others may destroy at any moment.
#ifndef OROFORGE_LIVE_LOOKUP_HPP
#define OROFORGE_LIVE_LOOKUP_HPP

#include "component_thread.hpp"

#include <console/visits.hpp>
#include <rtt/TaskContext.hpp>

#include <string>
#include <vector>

namespace OCL::live {

/** The deployer, as a place to begin. */
struct Root {
    Gate gate;
    std::string name;
};

using console::Visits;

struct Found {
    RTT::TaskContext* component = nullptr;  ///< null for a service of the process
    Gate gate;                              ///< of that component
    RTT::Service::shared_ptr service;       ///< in which the path ends, or `member` is
    std::string path;                       ///< of the service: "Arm.gripper"
    bool isComponent = false;               ///< the path ends at the component itself
    std::vector<std::string> rest;          ///< what comes after the service; empty if the path ends there
    std::vector<std::string> known;         ///< the names in place of the first part of the rest

    std::string componentName() const { return component ? component->getName() : std::string("GlobalService"); }
    std::string pathWith(const std::string& member) const { return path.empty() ? member : path + "." + member; }
};

/** Follows a path from the deployer through peers and services as far as it leads. `list[2]` is the same as `list.2`.
    Names of members may have dots; the longest one that exists is meant.
    An empty path is the deployer. Throws Failure if the deployer, or a component on the way, is gone. */
Found find(const Root& root, Visits& visits, const std::string& path);
/** The same for a component; throws Failure, with a hint, if the path leads to none. */
Found findComponent(const Root& root, Visits& visits, const std::string& path);
/** Throws the Failure that the first part of the rest is unknown, with the name that was perhaps meant. */
[[noreturn]] void unknown(const Found& found, const char* what);

}  // namespace OCL::live

#endif
