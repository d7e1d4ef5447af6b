// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MQ_TRANSPORTER_HPP
#define ORO_MQ_TRANSPORTER_HPP

#include <rtt/transports/mqueue/MQLib.hpp>
#include <rtt/transports/mqueue/message_format.hpp>
#include <rtt/types/TypeMarshaller.hpp>

#include <memory>
#include <string>

namespace RTT {
namespace mqueue {

/** Connects ports of one type to POSIX message queues, with the messages that a subclass defines. */
class RTT_API MQTransporter : public types::TypeMarshaller {
public:
    /**
     * Opens the queue `policy.name_id`, makes it if there is none, and fills in the name, if it is empty, and
     * `policy.data_size`. A sender sends a first message at once, which tells receivers the size of samples; a receiver
     * waits for that, up to 0.5 s, when it is connected. Logs errors. Not real-time safe.
     */
    base::ChannelElementBase::shared_ptr createStream(base::PortInterface* port, const ConnPolicy& policy,
                                                      bool is_sender) const override;

protected:
    /** For a new channel; null, with the reason in `why`, if the type cannot be sent. */
    virtual std::unique_ptr<MessageFormat> makeFormat(const types::TypeInfo& type, std::string& why) const = 0;
};

}  // namespace mqueue
}  // namespace RTT

#endif
