// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Types as typekits have them, and what generated typekit headers say of them: everything typed is instantiated once, in the
// library, and declared extern for those whose headers came before.
#ifndef ORO_API_INSTANTIATED_TYPES_HPP
#define ORO_API_INSTANTIATED_TYPES_HPP

#include <boost/array.hpp>
#include <boost/shared_ptr.hpp>

#include <string>
#include <vector>

namespace robot {

/** Neither operator== nor operator<<. */
struct Pose {
    double x, y, theta;
    std::string frame;
};
/** As in messages: nested, arrays, sequences. */
struct Scan {
    Pose origin;
    boost::array<double, 6> covariance;
    std::vector<Pose> points;
    float padding[32];
};
enum Mode { Idle, Moving };
typedef std::vector<Scan> Scans;
typedef boost::array<double, 6> Covariance;
typedef boost::shared_ptr<Pose> PosePtr;
typedef Pose* RawPose;

}  // namespace robot

#endif
