// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_NODE_STATE_HPP
#define RTT_ROSCOMM_NODE_STATE_HPP

#include <rtt_ros/node.hpp>

#include <chrono>
#include <functional>
#include <string>

namespace rtt_roscomm {

using rtt_ros::isNode;
using rtt_ros::isNodeReady;

/** Has a thread execute `work`, which asks the master, and waits for it, at most so long: a master that is stopped must not
    stop this process. If `work` is still going on, it has all that it needs, and ends some time later. */
void doWithin(std::function<void()> work, std::chrono::milliseconds limit);

/** As a part of `why`: "topic 'x y': …", from what roscpp throws. Executes `work`. */
bool isDone(const std::function<void()>& work, std::string& why);

}  // namespace rtt_roscomm

#endif
