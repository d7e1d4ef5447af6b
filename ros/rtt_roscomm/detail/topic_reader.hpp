// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_DETAIL_TOPIC_READER_HPP
#define RTT_ROSCOMM_DETAIL_TOPIC_READER_HPP

#include <ros/subscriber.h>
#include <rtt/ConnPolicy.hpp>
#include <rtt/base/ChannelElementBase.hpp>
#include <rtt_roscomm/detail/open_topics.hpp>
#include <rtt_roscomm/message_format.hpp>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include <boost/shared_ptr.hpp>

namespace RTT {
namespace base {
class PortInterface;
}
}  // namespace RTT

namespace rtt_roscomm::detail {

/** One input port's end of a topic: threads of the node's spinner write the samples into the storage of the port. */
class TopicReader : private OpenTopic {
public:
    TopicReader(const RTT::base::PortInterface& port, const RTT::ConnPolicy& policy,
                std::shared_ptr<const MessageFormat> format);
    ~TopicReader();

    /** Subscribes for `element`, whose output is the storage. False, with the reason in `why`, if that cannot be done.
        Asks the master. */
    bool open(RTT::base::ChannelElementBase& element, std::string& why);
    /** From then on, nothing is written. Waits for what is being written, unless that calls this, and at most 2 s for the
        master. */
    void close();

    const std::string& topic() const { return topic_; }
    const std::string& described() const { return described_; }
    const MessageFormat& format() const { return *format_; }
    TopicState state() const override;

private:
    class Receiver;
    const std::shared_ptr<const MessageFormat> format_;
    const std::string described_;  // for messages: the port and its type
    const std::string name_;
    const std::uint32_t queueSize_;
    const boost::shared_ptr<Receiver> receiver_;
    std::mutex changing_;  // open() and close() are called by different threads
    std::string topic_;
    ros::Subscriber subscriber_;
    bool isOpen_ = false;
};

}  // namespace rtt_roscomm::detail

#endif
