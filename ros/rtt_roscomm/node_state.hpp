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

/** Has a thread execute `work`, and waits for it, at most so long. If `work` is still going on then, it has all that it
    needs, and ends some time later. Exceptions are logged. */
void doWithin(std::function<void()> work, std::chrono::milliseconds limit);

/** Has a thread take something back from the master, such as a topic, and waits for it, at most 2 s. While the master does
    not answer, `work` is kept until it does: roscpp would wait, and hold what all topics of the process need. */
void endWithMaster(std::function<void()> work);
/** The same without waiting, for a callback that roscpp executes: it waits for the callback. */
void endWithMasterLater(std::function<void()> work);

/** This process registers the service, by its resolved name, with each master that was started anew, until
    dropService(). */
void keepService(const std::string& name);
void dropService(const std::string& name);

/** Executes `work`. False, with the text of what it throws in `why`, which is unchanged otherwise. */
bool isDone(const std::function<void()>& work, std::string& why);

}  // namespace rtt_roscomm

#endif
