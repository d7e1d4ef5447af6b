// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_TF_DETAIL_TRANSFORM_CHECK_HPP
#define RTT_TF_DETAIL_TRANSFORM_CHECK_HPP

#include <geometry_msgs/TransformStamped.h>

#include <string>

namespace rtt_tf::detail {

/** Why tf2 cannot use a transform, and what to do; empty if it can. Its frames are bare(). */
struct Refusal {
    enum Kind : unsigned { None = 0, NoFrame = 1, NoChild = 2, Same = 4, NotFinite = 8, NotUnit = 16 };
    Kind kind = None;
    std::string text;
    explicit operator bool() const { return kind != None; }
};
Refusal check(const geometry_msgs::TransformStamped& transform);

}  // namespace rtt_tf::detail

#endif
