// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MQUEUE_DETAIL_SEND_CHANNEL_HPP
#define ORO_MQUEUE_DETAIL_SEND_CHANNEL_HPP

#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/internal/flow/stream_sender.hpp>
#include <rtt/transports/mqueue/detail/queue.hpp>
#include <rtt/transports/mqueue/message_format.hpp>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace RTT {
namespace mqueue {
namespace detail {

/**
 * The last element of an output stream: writes samples into a queue, in the thread of the writer, without waiting and
 * without memory from the heap. Several threads may write at once.
 *
 * When the queue is full, the sample of a buffer is refused; otherwise the oldest one makes room for it, as in other
 * connections of that kind. A queue of such a connection has room for two messages at least, because the first one
 * stays until a receiver takes it.
 */
class SendChannel final : public base::ChannelElementBase, public internal::StreamSender {
public:
    SendChannel(std::unique_ptr<Queue> queue, std::unique_ptr<MessageFormat> format, bool keepsOldest,
                std::string described);
    ~SendChannel() override;

    WriteStatus writeErased(const void* sample) override { return send(sample); }
    /** Sends a first message. */
    WriteStatus sampleErased(const void* sample, bool reset) override;
    using base::ChannelElementBase::disconnect;
    bool disconnect(shared_ptr const& channel, bool forward) override;

    void withdrawName() override { unlink(); }

    bool isRemoteElement() const override { return true; }
    std::string getRemoteURI() const override { return queue_->name(); }
    std::string getElementName() const override { return "MQSendChannel"; }

private:
    struct Message {
        const void* at;
        std::size_t size;
        unsigned priority;
    };
    WriteStatus send(const void* sample);
    WriteStatus post(const Message& message);
    WriteStatus postInsteadOfOldest(const Message& message);
    void dropOldest();
    WriteStatus refuse(const void* sample);
    void unlink();

    const std::unique_ptr<Queue> queue_;
    const std::unique_ptr<MessageFormat> format_;
    const bool keepsOldest_;
    const std::string described_;                  // for messages: the port and its type
    std::atomic<std::uint32_t> busy_{0};           // os::detail::PriorityLock of the format and the buffers
    std::vector<char> message_, first_, dropped_;  // with room for a message
    bool begun_ = false;                           // the first message was sent
    std::atomic<int> reported_{0};                 // the error that was logged last; 0 after a success
    std::atomic<bool> linked_{true};
};

}  // namespace detail
}  // namespace mqueue
}  // namespace RTT

#endif
