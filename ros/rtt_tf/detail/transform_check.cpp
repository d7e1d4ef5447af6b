// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_tf/detail/transform_check.hpp>

#include <cmath>
#include <sstream>

namespace rtt_tf::detail {

namespace {

/** That of tf2, of the square of the length. */
constexpr double kTolerance = 10e-3;

bool isFinite(const geometry_msgs::Transform& transform) {
    const auto& move = transform.translation;
    const auto& turn = transform.rotation;
    for (const double value : {move.x, move.y, move.z, turn.x, turn.y, turn.z, turn.w})
        if (!std::isfinite(value)) return false;
    return true;
}

}  // namespace

Refusal check(const geometry_msgs::TransformStamped& transform) {
    const std::string& frame = transform.header.frame_id;
    const std::string& child = transform.child_frame_id;
    if (child.empty()) return {Refusal::NoChild, "a transform from frame '" + frame + "' has an empty child_frame_id"};
    if (frame.empty()) return {Refusal::NoFrame, "the transform to frame '" + child + "' has an empty header.frame_id"};
    if (frame == child) return {Refusal::Same, "the transform to frame '" + child + "' has the same header.frame_id"};
    std::ostringstream text;
    const auto& move = transform.transform.translation;
    const auto& turn = transform.transform.rotation;
    text << "the transform from frame '" << frame << "' to frame '" << child << "' has ";
    if (!isFinite(transform.transform)) {
        text << "a value that is not finite: translation " << move.x << ' ' << move.y << ' ' << move.z << ", rotation "
             << turn.x << ' ' << turn.y << ' ' << turn.z << ' ' << turn.w;
        return {Refusal::NotFinite, text.str()};
    }
    const double square = turn.x * turn.x + turn.y * turn.y + turn.z * turn.z + turn.w * turn.w;
    if (std::fabs(square - 1) <= kTolerance) return {};
    text << "a rotation of length " << std::sqrt(square) << "; use a quaternion of length 1, such as x 0, y 0, z 0, w 1";
    return {Refusal::NotUnit, text.str()};
}

}  // namespace rtt_tf::detail
