// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/topic_channel.hpp>

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/PortInterface.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt_roscomm/detail/topic_name.hpp>
#include <rtt_roscomm/detail/topic_reader.hpp>
#include <rtt_roscomm/detail/topic_writer.hpp>

#include <string>
#include <utility>

namespace rtt_roscomm {

using detail::TopicReader;
using detail::TopicWriter;
using RTT::WriteStatus;
using RTT::base::ChannelElementBase;

namespace {

class PublishChannel final : public ChannelElementBase, public RosPublisher {
public:
    explicit PublishChannel(TopicWriter::Pointer writer) : writer_(std::move(writer)) {}
    ~PublishChannel() override { writer_->close(); }

    WriteStatus writeErased(const void* sample) override { return writer_->write(sample); }
    void publish() override { writer_->publishDue(); }
    WriteStatus sampleErased(const void* sample, bool reset) override { return writer_->setSample(sample, reset); }
    using ChannelElementBase::disconnect;
    bool disconnect(shared_ptr const& channel, bool forward) override {
        writer_->close();
        return ChannelElementBase::disconnect(channel, forward);
    }

    bool isRemoteElement() const override { return true; }
    std::string getRemoteURI() const override { return writer_->topic(); }
    std::string getElementName() const override { return "RosPubChannelElement"; }

private:
    const TopicWriter::Pointer writer_;
};

class SubscribeChannel final : public ChannelElementBase {
public:
    SubscribeChannel(const RTT::base::PortInterface& port, const RTT::ConnPolicy& policy,
                     std::shared_ptr<const MessageFormat> format)
        : name_(policy.name_id), reader_(port, policy, std::move(format)) {}

    using ChannelElementBase::inputReady;
    // Not before, because a latched message comes at once.
    bool inputReady() override {
        std::string why;
        if (reader_.open(*this, why)) return true;
        detail::tellRefused(reader_.described(), name_, why);
        return false;
    }
    using ChannelElementBase::disconnect;
    bool disconnect(shared_ptr const& channel, bool forward) override {
        reader_.close();
        return ChannelElementBase::disconnect(channel, forward);
    }

    bool isRemoteElement() const override { return true; }
    std::string getRemoteURI() const override { return reader_.topic(); }
    std::string getElementName() const override { return "RosSubChannelElement"; }

private:
    const std::string name_;
    TopicReader reader_;
};

}  // namespace

ChannelElementBase::shared_ptr newTopicChannel(RTT::base::PortInterface& port, const RTT::ConnPolicy& policy,
                                               std::shared_ptr<const MessageFormat> format, bool isSender) {
    std::string why;
    const RTT::base::DataSourceBase::shared_ptr first = port.getTypeInfo()->buildValue();
    if (!port.getTypeInfo()->getOps() || !first || !first->getRawConstPointer())
        why = "its type has no default value";
    else if (policy.pull)
        why = "the samples of a topic cannot be pulled; set policy.pull to false";
    else if (!isSender || !policy.name_id.empty())
        why = detail::whyNoTopic(policy.name_id);
    if (!why.empty()) {
        detail::tellRefused(detail::describe(port), policy.name_id, why);
        return nullptr;
    }
    if (!isSender)
        return new SubscribeChannel(port, policy, std::move(format));
    if (const TopicWriter::Pointer writer = TopicWriter::make(port, policy, std::move(format), why))
        return new PublishChannel(writer);
    detail::tellRefused(detail::describe(port), policy.name_id, why);
    return nullptr;
}

}  // namespace rtt_roscomm
