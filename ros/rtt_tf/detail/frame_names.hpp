// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_TF_DETAIL_FRAME_NAMES_HPP
#define RTT_TF_DETAIL_FRAME_NAMES_HPP

#include <string>

namespace rtt_tf::detail {

/** Names of frames have no slash in front in tf2; older programs write one. */
std::string bare(const std::string& frame);
/** "robot1/base" for "base". A frame with a slash in front is global: "map" for "/map". */
std::string prefixed(const std::string& prefix, const std::string& frame);
/** A prefix without the slashes at its ends. */
std::string trimmed(std::string prefix);

}  // namespace rtt_tf::detail

#endif
