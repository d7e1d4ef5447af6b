// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_DETAIL_TOPIC_WRITER_HPP
#define RTT_ROSCOMM_DETAIL_TOPIC_WRITER_HPP

#include <ros/publisher.h>
#include <rtt/ConnPolicy.hpp>
#include <rtt/FlowStatus.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt_roscomm/detail/due_publisher.hpp>
#include <rtt_roscomm/detail/lane.hpp>
#include <rtt_roscomm/detail/open_topics.hpp>
#include <rtt_roscomm/message_format.hpp>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <boost/smart_ptr/intrusive_ptr.hpp>

namespace RTT {
namespace base {
class PortInterface;
}
namespace internal {
class SampleStore;
}
}  // namespace RTT

namespace rtt_roscomm::detail {

/** One output port's end of a topic: keeps samples until the publish activity sends them. */
class TopicWriter final : public DuePublisher, private OpenTopic, private RosPublisher {
public:
    typedef boost::intrusive_ptr<TopicWriter> Pointer;

    /** Advertises the topic `policy.name_id`, which is filled in if it is empty. Null, with the reason in `why`, if that
        cannot be done. Asks the master. */
    static Pointer make(const RTT::base::PortInterface& port, const RTT::ConnPolicy& policy,
                        std::shared_ptr<const MessageFormat> format, std::string& why);
    ~TopicWriter() override;

    /** Real-time safe, unless the policy is UNBUFFERED. */
    RTT::WriteStatus write(const void* sample);
    /** A sample of the largest size, which is not sent. */
    RTT::WriteStatus setSample(const void* sample, bool reset);
    /** Sends no more and takes the topic back. Waits for what is being sent, and for the master, at most some seconds. */
    void close();

    const std::string& topic() const { return topic_; }
    const std::string& described() const { return described_; }
    const MessageFormat& format() const { return *format_; }
    TopicState state() const override;

    void publishDue() override;

private:
    TopicWriter(const RTT::base::PortInterface& port, std::shared_ptr<const MessageFormat> format);
    bool makeStore(const RTT::base::PortInterface& port, const RTT::ConnPolicy& policy);
    bool advertise(const RTT::ConnPolicy& policy, std::string& why);
    void publish() override;  // by the lane
    void publishAll();
    void leaveTheOthers();
    bool send(const void* sample);

    RosPublishActivity& activity_;
    const std::shared_ptr<const MessageFormat> format_;
    const std::string described_;  // for messages: the port and its type
    std::string topic_;
    std::unique_ptr<RTT::internal::SampleStore> store_;  // null if unbuffered
    const RTT::base::DataSourceBase::shared_ptr sample_;  // the one that is sent
    ros::Publisher publisher_;
    std::timed_mutex sending_;  // one thread sends at a time
    std::mutex laneMutex_;      // guards isOpen_ and lane_; held for moments only
    bool isOpen_ = false;
    std::unique_ptr<Lane> lane_;
    std::atomic<bool> isClosed_{false}, isSlow_{false};
    std::vector<std::uint8_t> bytes_;  // the message of a slow one
    std::atomic<std::uint64_t> published_{0};
    std::atomic<bool> complained_{false};
};

}  // namespace rtt_roscomm::detail

#endif
