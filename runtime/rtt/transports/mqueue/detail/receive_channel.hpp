// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MQUEUE_DETAIL_RECEIVE_CHANNEL_HPP
#define ORO_MQUEUE_DETAIL_RECEIVE_CHANNEL_HPP

#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/transports/mqueue/detail/queue.hpp>
#include <rtt/transports/mqueue/message_format.hpp>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace RTT {
namespace mqueue {
namespace detail {

/** The first element of an input stream: the Dispatcher's thread takes the messages out of the queue and writes their
    samples into the storage behind it. */
class ReceiveChannel final : public base::ChannelElementBase {
public:
    typedef boost::intrusive_ptr<ReceiveChannel> Pointer;

    /** `sample`: a value of the type. */
    ReceiveChannel(std::unique_ptr<Queue> queue, std::unique_ptr<MessageFormat> format,
                   base::DataSourceBase::shared_ptr sample, std::string described);

    using base::ChannelElementBase::inputReady;
    /** Waits for the first message, up to 0.5 s, and has the Dispatcher take the later ones. False, with an error
        logged, if it does not come. */
    bool inputReady() override;
    using base::ChannelElementBase::disconnect;
    bool disconnect(shared_ptr const& channel, bool forward) override;

    bool isRemoteElement() const override { return true; }
    std::string getRemoteURI() const override { return name_; }
    const std::string& queueName() const { return name_; }
    std::string getElementName() const override { return "MQReceiveChannel"; }

    // For the Dispatcher's thread.
    const Queue& queue() const { return *queue_; }
    /** Delivers a message if there is one. Only one, so that other queues get their turn. */
    void receive();
    /** Delivers what is left in the present queue and takes another one. */
    void exchangeQueue(std::unique_ptr<Queue> queue);

private:
    enum class Taken { None, Sample, First, Bad };
    Taken take();
    void deliver();
    void refuse(const std::string& why);

    const std::string name_;
    std::unique_ptr<Queue> queue_;
    const std::unique_ptr<MessageFormat> format_;
    const base::DataSourceBase::shared_ptr sample_;
    const std::string described_;  // for messages: the port and its type
    std::vector<char> message_;    // with room for a message
    bool complained_ = false;
    std::atomic<bool> started_{false};
};

}  // namespace detail
}  // namespace mqueue
}  // namespace RTT

#endif
