// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What users write: nothing of ROS but names.
#ifndef OROFORGE_TESTS_ROS_MESSAGES_TAGGED_TYPES_HPP
#define OROFORGE_TESTS_ROS_MESSAGES_TAGGED_TYPES_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tagged {

struct Vector {
    double x = 0, y = 0, z = 0;
};

/// Where the hand is. @ros geometry_msgs/Pose e45d45a5a1ce597b249e23fb30fc871f
struct Hand {
    Vector place;
    std::array<double, 4> rotation = {};
};

struct Stamp {
    std::uint32_t seconds = 0, nanoseconds = 0;
};
struct Head {
    std::uint32_t number = 0;
    Stamp stamp;
    std::string frame;
};

/// @ros geometry_msgs/PoseArray
struct Path {
    Head head;
    std::vector<Hand> hands;
};

}  // namespace tagged

#endif
