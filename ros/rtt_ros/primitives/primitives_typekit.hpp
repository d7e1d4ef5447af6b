// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROS_PRIMITIVES_TYPEKIT_HPP
#define RTT_ROS_PRIMITIVES_TYPEKIT_HPP

#include <rtt/types/TypekitPlugin.hpp>

namespace rtt_ros {

/** The typekit "ros-primitives": names of messages for numbers and strings, their vectors and arrays, time and
    duration. */
class PrimitivesTypekit : public RTT::types::TypekitPlugin {
public:
    bool loadTypes() override;
    bool loadConstructors() override;
    bool loadOperators() override { return true; }
    std::string getName() override { return "ros-primitives"; }
};

/** Adds "int8[]" and so on, std::vector, and "cint8[]", the type of arrays in structs. */
bool addVectors();

}  // namespace rtt_ros

#endif
