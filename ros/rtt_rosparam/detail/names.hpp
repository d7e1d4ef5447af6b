// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSPARAM_DETAIL_NAMES_HPP
#define RTT_ROSPARAM_DETAIL_NAMES_HPP

#include <rtt_rosparam/resolution_policy.hpp>

#include <string>

namespace rtt_rosparam {

/** The name of ROS for an item of a component; with an empty one for the namespace. Throws Failure for a number that is
    no policy. */
std::string nameOf(const std::string& component, unsigned policy, const std::string& item);

/** The name from the root, with remappings. Throws Failure if this is not a node or the name is malformed. */
std::string resolved(const std::string& name);

}  // namespace rtt_rosparam

#endif
