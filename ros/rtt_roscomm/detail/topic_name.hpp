// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_DETAIL_TOPIC_NAME_HPP
#define RTT_ROSCOMM_DETAIL_TOPIC_NAME_HPP

#include <cstddef>
#include <string>

namespace RTT {
namespace base {
class PortInterface;
}
}  // namespace RTT

namespace rtt_roscomm {
class MessageFormat;
namespace detail {

/** The most bytes that a receiver takes for one message. */
constexpr std::size_t kLargestMessage = 1000000000;

/** "output port c.out of type /double", for messages. */
std::string describe(const RTT::base::PortInterface& port);
/** A valid name of a topic that no other port of this network has. */
std::string newTopicName(const RTT::base::PortInterface& port);

/** A name that begins with "~" is one in the private namespace of the node. The two parts that a NodeHandle wants. */
std::string namespaceOf(const std::string& name);
std::string nameWithin(const std::string& name);

/** Why no topic can have this name, which roscpp would not tell, or would take. Empty if one can. */
std::string whyNoTopic(const std::string& name);

/** Why roscpp refused the topic, of that resolved name. */
std::string whyRefused(const std::string& topic, const MessageFormat& format);
/** Logs a warning if others publish or receive another type of message there. Asks the master. */
void warnOfOtherType(const std::string& described, const std::string& topic, const MessageFormat& format);

/** Logs that a port has no stream. */
void tellRefused(const std::string& described, const std::string& topic, const std::string& why);

}  // namespace detail
}  // namespace rtt_roscomm

#endif
