// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// For packages of this family that use roscpp themselves.
#ifndef RTT_ROSCOMM_NODE_STATE_HPP
#define RTT_ROSCOMM_NODE_STATE_HPP

#include <chrono>
#include <functional>
#include <string>

namespace rtt_roscomm::detail {

/** This process is a node, and its master answers within a second. Otherwise false, with what to do in `why`. */
bool isNodeReady(std::string& why);

/** Has a thread execute `work`, which asks the master, and waits for it, at most so long: a master that is stopped must not
    stop this process. If `work` is still going on, it has all that it needs, and ends some time later. */
void doWithin(std::function<void()> work, std::chrono::milliseconds limit);

/** As a part of `why`: "topic 'x y': …", from what roscpp throws. Executes `work`. */
bool isDone(const std::function<void()>& work, std::string& why);

/** A master that was started again is told of this service, by its resolved name, until it is dropped. */
void keepService(const std::string& name);
void dropService(const std::string& name);

}  // namespace rtt_roscomm::detail

#endif
