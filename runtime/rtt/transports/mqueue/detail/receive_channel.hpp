// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MQUEUE_DETAIL_RECEIVE_CHANNEL_HPP
#define ORO_MQUEUE_DETAIL_RECEIVE_CHANNEL_HPP

#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/os/Mutex.hpp>
#include <rtt/transports/mqueue/detail/queue.hpp>
#include <rtt/transports/mqueue/message_format.hpp>

#include <memory>
#include <string>
#include <vector>

namespace RTT {
namespace mqueue {
namespace detail {

/**
 * The first element of an input stream: the Dispatcher's thread takes the messages out of the queue and writes their
 * samples into the storage behind it. A sample for which a buffer has no room stays here, and the messages behind it
 * stay in the queue, so that the sender learns that it is full.
 */
class ReceiveChannel final : public base::ChannelElementBase {
public:
    typedef boost::intrusive_ptr<ReceiveChannel> Pointer;

    /** `sample`: a value of the type. `waits`: the storage may have no room for a sample. */
    ReceiveChannel(std::string queue, std::unique_ptr<MessageFormat> format, base::DataSourceBase::shared_ptr sample,
                   bool waits, std::string described);

    using base::ChannelElementBase::inputReady;
    /** Waits for the queue and its first message, up to 0.5 s, and has the Dispatcher take the later ones. False, with
        an error logged, if there is no queue. */
    bool inputReady() override;
    using base::ChannelElementBase::disconnect;
    bool disconnect(shared_ptr const& channel, bool forward) override;

    bool isRemoteElement() const override { return true; }
    std::string getRemoteURI() const override { return name_; }
    std::string getElementName() const override { return "MQReceiveChannel"; }
    const std::string& queueName() const { return name_; }

    // For the Dispatcher's thread.
    const Queue& queue() const { return *queue_; }
    /** A sample waits for room: there is no use in looking at the queue. */
    bool isHeldUp() const { return heldUp_; }
    /** Delivers a message if there is one. Only one, so that other queues get their turn. */
    void receive();
    /** If somebody has made another queue of that name: delivers what is left in this one, and takes the other. */
    bool followQueue();

private:
    enum class Taken { None, Sample, First, Bad };
    bool findQueue(std::string& why);
    class Patience;
    bool waitForFirst(const Patience& patience);
    Taken take();
    void deliver();
    void refuse(const std::string& why);

    const std::string name_;
    std::unique_ptr<Queue> queue_;  // from inputReady() on
    const std::unique_ptr<MessageFormat> format_;
    const base::DataSourceBase::shared_ptr sample_;
    const bool waits_;
    const std::string described_;  // for messages: the port and its type
    std::vector<char> message_;    // with room for a message
    bool complained_ = false, heldUp_ = false;
    os::Mutex mutex_;  // guards started_: no message is taken for a port that has left
    bool started_ = false;
};

}  // namespace detail
}  // namespace mqueue
}  // namespace RTT

#endif
