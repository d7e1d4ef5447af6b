// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef T13_OLD_SCRIPTS_POSE_HPP
#define T13_OLD_SCRIPTS_POSE_HPP

namespace arm {

struct Joint {
    double q = 0;  ///< angle in rad
};

struct Pose {
    Joint shoulder;
    Joint elbow;
};

}  // namespace arm
#endif
