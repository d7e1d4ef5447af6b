// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_TOPIC_CHANNEL_HPP
#define RTT_ROSCOMM_TOPIC_CHANNEL_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/base/ChannelElementBase.hpp>
#include <rtt_roscomm/message_format.hpp>

#include <memory>

namespace RTT {
namespace base {
class PortInterface;
}
}  // namespace RTT

namespace rtt_roscomm {

/** The channel element of a stream: the last one behind an output port, which is a RosPublisher, too, or the first one
    before an input port. Null, with an error logged, if there is none. Asks the master; not real-time safe. */
RTT::base::ChannelElementBase::shared_ptr newTopicChannel(RTT::base::PortInterface& port, const RTT::ConnPolicy& policy,
                                                          std::shared_ptr<const MessageFormat> format, bool isSender);

}  // namespace rtt_roscomm

#endif
