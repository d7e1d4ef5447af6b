// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/message_table.hpp>

#include <rtt/Logger.hpp>
#include <rtt_roscomm/detail/topic_name.hpp>
#include <rtt_roscomm/rostopic.h>
#include <rtt_roscomm/topic_channel.hpp>

#include <algorithm>
#include <memory>
#include <utility>

namespace rtt_roscomm {

namespace {

/** For the ports of one type, by its shape. */
class TopicTransporter final : public RTT::types::TypeTransporter {
public:
    explicit TopicTransporter(const MessageEntry& entry) : entry_(entry) {}

    RTT::base::ChannelElementBase::shared_ptr createStream(RTT::base::PortInterface* port,
                                                           const RTT::ConnPolicy& policy,
                                                           bool is_sender) const override {
        const RTT::Logger::In in("rostopic");
        std::string why;
        std::shared_ptr<const MessageFormat> format = newMessageFormat(*port->getTypeInfo(), entry_, why);
        if (format) return newTopicChannel(*port, policy, std::move(format), is_sender);
        detail::tellRefused(detail::describe(*port), policy.name_id, why);
        return nullptr;
    }
    /** A transporter that was written for the type takes its place. */
    bool isGeneric() const override { return true; }

private:
    const MessageEntry& entry_;
};

}  // namespace

MessageTransport::MessageTransport(std::string package, const MessageEntry* first, std::size_t count)
    : package_(std::move(package)), first_(first), count_(count) {}

bool MessageTransport::registerTransport(std::string type_name, RTT::types::TypeInfo* info) {
    const MessageEntry* const end = first_ + count_;
    const MessageEntry* const entry =
        std::find_if(first_, end, [&](const MessageEntry& one) { return type_name == one.type; });
    return entry != end && info->addProtocol(protocol_id, new TopicTransporter(*entry));
}

std::string MessageTransport::getTransportName() const { return "ros"; }
std::string MessageTransport::getTypekitName() const { return "ros-" + package_; }
std::string MessageTransport::getName() const { return "rtt-ros-" + package_ + "-transport"; }

}  // namespace rtt_roscomm
