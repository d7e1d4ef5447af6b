// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/message_table.hpp>

#include <rtt/Logger.hpp>
#include <rtt/types/MessageNames.hpp>
#include <rtt/types/TypeInfoRepository.hpp>
#include <rtt_roscomm/detail/topic_name.hpp>
#include <rtt_roscomm/rostopic.h>
#include <rtt_roscomm/topic_channel.hpp>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

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
    const MessageEntry entry_;
};

MessageEntry entryOf(const RTT::types::MessageName& announced) {
    return {announced.type.c_str(), announced.message.c_str(), announced.md5.c_str(), announced.definition.c_str()};
}

/** For types that typekits announce as messages. */
class AnnouncedTransport final : public RTT::types::TransportPlugin {
public:
    /** A typekit announces before it registers its types; this is for types that another one has registered. */
    static void add(const RTT::types::MessageName& announced) {
        const std::vector<std::string> known = RTT::types::Types()->getTypes();
        // Asking for a type that is not known would have the typekits searched that are not loaded.
        if (std::find(known.begin(), known.end(), announced.type) == known.end()) return;
        RTT::types::TypeInfo* const info = RTT::types::Types()->type(announced.type);
        if (info && !info->hasProtocol(protocol_id)) addTo(*info, announced);
    }
    bool registerTransport(std::string /*type_name*/, RTT::types::TypeInfo* info) override {
        for (const std::string& name : info->getTypeNames())
            if (const RTT::types::MessageName* const announced = RTT::types::announcedMessage(name))
                return addTo(*info, *announced);
        return false;
    }
    std::string getTransportName() const override { return "ros"; }
    std::string getTypekitName() const override { return "announced"; }
    std::string getName() const override { return "rtt-ros-announced-transport"; }

private:
    static bool addTo(RTT::types::TypeInfo& info, const RTT::types::MessageName& announced) {
        return info.addProtocol(protocol_id, new TopicTransporter(entryOf(announced)));
    }
};

}  // namespace

MessageTransport::MessageTransport(std::string package, const MessageEntry* first, std::size_t count)
    : package_(std::move(package)), first_(first), count_(count) {}

bool MessageTransport::registerTransport(std::string /*type_name*/, RTT::types::TypeInfo* info) {
    // Another typekit may have registered the type before, by a name of its own.
    const std::vector<std::string> names = info->getTypeNames();
    const MessageEntry* const end = first_ + count_;
    const MessageEntry* const entry = std::find_if(
        first_, end, [&](const MessageEntry& one) { return std::find(names.begin(), names.end(), one.type) != names.end(); });
    return entry != end && info->addProtocol(protocol_id, new TopicTransporter(*entry));
}

void serveAnnouncedMessages() {
    static const bool once = [] {
        RTT::types::TypekitRepository::Import(new AnnouncedTransport());
        RTT::types::watchMessages(&AnnouncedTransport::add);
        return true;
    }();
    (void)once;
}

std::string MessageTransport::getTransportName() const { return "ros"; }
std::string MessageTransport::getTypekitName() const { return "ros-" + package_; }
std::string MessageTransport::getName() const { return "rtt-ros-" + package_ + "-transport"; }

}  // namespace rtt_roscomm
