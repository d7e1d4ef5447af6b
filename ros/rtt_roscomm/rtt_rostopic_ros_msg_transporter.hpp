// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The transport of topics for a C++ type, compiled for it. Types with a table need none: theirs is made from the table.
#ifndef RTT_ROSCOMM_RTT_ROSTOPIC_ROS_MSG_TRANSPORTER_HPP
#define RTT_ROSCOMM_RTT_ROSTOPIC_ROS_MSG_TRANSPORTER_HPP

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <rtt/base/ChannelElement.hpp>
#include <rtt/types/TypeTransporter.hpp>
#include <rtt_roscomm/message_format.hpp>
#include <rtt_roscomm/rostopic.h>
#include <rtt_roscomm/rtt_rostopic_ros_publish_activity.hpp>
#include <rtt_roscomm/topic_channel.hpp>

#include <exception>
#include <memory>
#include <string>
#include <type_traits>

namespace rtt_roscomm {

/** How samples of T become messages and back. Specialise it for types that are no messages themselves. */
template <class T>
struct RosMessageAdapter {
    typedef T OrocosType;
    typedef T RosType;
    static const RosType& toRos(const OrocosType& sample) { return sample; }
    static const OrocosType& fromRos(const RosType& message) { return message; }
};

/** The messages of RosMessageAdapter<T>. */
template <class T>
class AdaptedFormat final : public MessageFormat {
    typedef RosMessageAdapter<T> Adapter;
    typedef typename std::decay<typename Adapter::RosType>::type Message;

public:
    std::string message() const override { return ros::message_traits::datatype<Message>(); }
    std::string md5() const override { return ros::message_traits::md5sum<Message>(); }
    std::string definition() const override { return ros::message_traits::definition<Message>(); }
    bool hasHeader() const override { return ros::message_traits::hasHeader<Message>(); }

    bool sizeOf(const void* sample, std::size_t& size) const override {
        size = ros::serialization::serializationLength(Adapter::toRos(*static_cast<const T*>(sample)));
        return true;
    }
    bool write(const void* sample, void* to, std::size_t size) const override {
        ros::serialization::OStream stream(static_cast<std::uint8_t*>(to), static_cast<std::uint32_t>(size));
        ros::serialization::serialize(stream, Adapter::toRos(*static_cast<const T*>(sample)));
        return stream.getLength() == 0;
    }
    bool read(const void* from, std::size_t size, void* sample, std::string& why) const override {
        try {
            // Streams of roscpp are for writing, too.
            ros::serialization::IStream stream(static_cast<std::uint8_t*>(const_cast<void*>(from)),
                                               static_cast<std::uint32_t>(size));
            Message message;
            ros::serialization::deserialize(stream, message);
            *static_cast<T*>(sample) = Adapter::fromRos(message);
            return true;
        } catch (const std::exception& error) {
            why = error.what();
            return false;
        }
    }
};

/** The last element of an output stream. As real-time safe as its policy, see topic(). */
template <class T>
class RosPubChannelElement : public RTT::base::ChannelElement<T>, public RosPublisher {
    typedef RTT::base::ChannelElementBase Base;

public:
    RosPubChannelElement(RTT::base::PortInterface* port, const RTT::ConnPolicy& policy)
        : channel_(newTopicChannel(*port, policy, std::make_shared<AdaptedFormat<T>>(), true)) {}

    /** False if the topic could not be advertised; an error was logged. */
    bool isOpen() const { return channel_ != nullptr; }
    bool inputReady() override { return isOpen(); }
    void publish() override {
        if (auto* const publisher = dynamic_cast<RosPublisher*>(channel_.get())) publisher->publish();
    }
    RTT::WriteStatus write(const T& sample) override {
        return channel_ ? channel_->writeErased(&sample) : RTT::NotConnected;
    }
    RTT::WriteStatus data_sample(const T& sample, bool reset) override {
        return channel_ ? channel_->sampleErased(&sample, reset) : RTT::NotConnected;
    }
    using Base::disconnect;
    bool disconnect(Base::shared_ptr const& channel, bool forward) override {
        if (channel_) (void)channel_->disconnect(nullptr, forward);
        return Base::disconnect(channel, forward);
    }
    bool isRemoteElement() const override { return true; }
    std::string getRemoteURI() const override { return channel_ ? channel_->getRemoteURI() : std::string(); }
    std::string getElementName() const override { return "RosPubChannelElement"; }

private:
    const Base::shared_ptr channel_;
};

/** The first element of an input stream. */
template <class T>
class RosSubChannelElement : public RTT::base::ChannelElement<T> {
    typedef RTT::base::ChannelElementBase Base;

public:
    RosSubChannelElement(RTT::base::PortInterface* port, const RTT::ConnPolicy& policy)
        : channel_(newTopicChannel(*port, policy, std::make_shared<AdaptedFormat<T>>(), false)) {}

    using Base::inputReady;
    /** Subscribes. */
    bool inputReady() override {
        if (!channel_) return false;
        if (!Base::getInput()) (void)channel_->connectTo(this);
        if (channel_->inputReady()) return true;
        (void)channel_->disconnect(nullptr, false);  // Else the two would keep each other.
        return false;
    }
    bool isRemoteElement() const override { return true; }
    std::string getRemoteURI() const override { return channel_ ? channel_->getRemoteURI() : std::string(); }
    std::string getElementName() const override { return "RosSubChannelElement"; }

private:
    const Base::shared_ptr channel_;
};

template <class T>
class RosMsgTransporter : public RTT::types::TypeTransporter {
public:
    RTT::base::ChannelElementBase::shared_ptr createStream(RTT::base::PortInterface* port,
                                                           const RTT::ConnPolicy& policy,
                                                           bool is_sender) const override {
        if (!is_sender) return new RosSubChannelElement<T>(port, policy);
        const boost::intrusive_ptr<RosPubChannelElement<T>> made(new RosPubChannelElement<T>(port, policy));
        if (!made->isOpen()) return nullptr;
        return made;
    }
};

}  // namespace rtt_roscomm

#endif
