// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Policies of streams that connect ports to topics of ROS.
#ifndef RTT_ROSCOMM_ROSTOPIC_H
#define RTT_ROSCOMM_ROSTOPIC_H

#include <rtt/ConnPolicy.hpp>

#include <string>

/** The transport of topics, for ConnPolicy::transport. */
#define ORO_ROS_PROTOCOL_ID 3

namespace rtt_roscomm {

static const int protocol_id = ORO_ROS_PROTOCOL_ID;

/**
 * Policies for PortInterface::createStream(). An output port becomes a publisher, an input port a subscriber of that
 * topic. The name may be relative to the namespace of the node, absolute, or, with `~` in front, private to the node.
 * Allocates.
 *
 * topic(): what the publisher has not sent yet is replaced by the next sample.
 */
RTT::ConnPolicy topic(const std::string& name);
/** As topic(); a subscriber that comes later gets the last message. */
RTT::ConnPolicy topicLatched(const std::string& name);
/** A number of samples waits; the next one is refused. */
RTT::ConnPolicy topicBuffer(const std::string& name, int size);
/** The thread that writes sends the message itself, which is not real-time safe. */
RTT::ConnPolicy topicUnbuffered(const std::string& name);

}  // namespace rtt_roscomm

#endif
