// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROS_NODE_HPP
#define RTT_ROS_NODE_HPP

#include <string>

namespace rtt_ros {

/**
 * Is this process a ROS node? If not, `why` says what to do: import rtt_rosnode, or start the master. Call it before the
 * first ros::NodeHandle of each use: one that is made without a started node starts the node, and waits for the master
 * without end.
 *
 * If rtt_rosnode found no master, this looks for it again, at most once a second, which blocks for up to 0.8 s while a
 * master that is not there is looked for. Any thread may call it; it is not real-time.
 */
bool isNode(std::string& why);

/** The same, and the master answers now, within a second: call it before roscpp asks the master, because roscpp waits
    without end for one that is stopped. */
bool isNodeReady(std::string& why);

/** Has something else ended the node: `rosnode kill`, the master because another node took its name, or a call of
    ros::shutdown()? */
bool isNodeLost();

/**
 * Makes this process a ROS node with the arguments of __os_init(), unless it is one, and starts a spinner for the
 * callbacks of the global queue, with as many threads as parameter `~spinner_threads` says. Without a master, logs
 * where it was looked for; isNodeReady() and later calls try again. False if the node can never start: its name or an
 * argument is invalid. For plugin `rosnode`.
 */
bool startNode();

/** Ends the spinner, then the node, for good; callbacks have ended when it returns, but for those that take longer than 3 s
    more, after an error in the log. For plugin `rosnode`. */
void stopNode();

}  // namespace rtt_ros

#endif
