// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "message_decoder.hpp"

#include "type_difference.hpp"

#include <rtt/encoding/SchemaText.hpp>

#include <cstdio>
#include <utility>

namespace OCL::replay {
namespace {

namespace mcap = oroforge::mcap;
namespace encoding = RTT::encoding;
using oroforge::schema::MessageSchema;

constexpr std::size_t kHead = 4;

std::string hexOf(std::uint64_t number) {
    char text[17];
    (void)std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
    return text;
}

bool hasFingerprint(const mcap::Channel& channel, std::uint64_t fingerprint) {
    const auto found = channel.metadata.find("oroforge.fingerprint");
    return found != channel.metadata.end() && found->second == hexOf(fingerprint);
}

/** In the language and with the names of the recorded description, if the type can have it. */
bool describe(const RTT::types::TypeInfo& type, const std::string& language, encoding::SchemaText& text,
              std::string& why) {
    const bool isRos = language == "ros2msg";
    return encoding::describeType(type, isRos ? encoding::SchemaLanguage::Auto : encoding::SchemaLanguage::OmgIdl,
                                  isRos, text, why);
}

}  // namespace

std::unique_ptr<MessageDecoder> MessageDecoder::make(const RTT::types::TypeInfo& type, const mcap::Channel& channel,
                                                     const mcap::Schema* schema, bool tolerate, Refusal& refusal) {
    if (channel.encoding != "cdr") {
        refusal = {"MCP022", "its messages are encoded as '" + channel.encoding + "', and only cdr is replayed"};
        return nullptr;
    }
    std::string why;
    std::shared_ptr<const encoding::Plan> plan = encoding::Plan::make(type, encoding::cdrRules(), why);
    if (!plan) {
        refusal = {"MCP021", "values of its type '" + type.getTypeName() + "' cannot be made from bytes: " + why};
        return nullptr;
    }
    const bool isSame = hasFingerprint(channel, plan->fingerprint());
    std::unique_ptr<MessageDecoder> result(new MessageDecoder(std::move(plan)));
    if (isSame) return result;
    if (!schema) {
        refusal = {"MCP023", "the file does not describe the type, so that it is not known whether '" +
                                 type.getTypeName() + "' has its fields"};
        return nullptr;
    }
    return result->compare(type, *schema, tolerate, refusal) ? std::move(result) : nullptr;
}

bool MessageDecoder::compare(const RTT::types::TypeInfo& type, const mcap::Schema& schema, bool tolerate,
                             Refusal& refusal) {
    std::string why;
    encoding::SchemaText text;
    MessageSchema recorded, loaded;
    if (!describe(type, schema.encoding, text, why) || !loaded.read(text.encoding, text.name, text.text, why)) {
        refusal = {"MCP021", "the loaded type '" + type.getTypeName() + "' cannot be compared: " + why};
        return false;
    }
    if (!recorded.read(schema.encoding, schema.name, schema.data, why)) {
        refusal = {"MCP023", "the description of its type cannot be read: " + why};
        return false;
    }
    const TypeDifference difference = compareTypes(recorded, loaded);
    if (!difference) return true;
    if (!tolerate || !difference.sharesField) {
        refusal = {"MCP023",
                   "the loaded type '" + type.getTypeName() + "' is not the recorded one: " + difference.text()};
        return false;
    }
    refusal = {"MCP024", "fields are replayed as far as the loaded type '" + type.getTypeName() +
                             "' and the recorded one are the same: " + difference.text()};
    transcoder_.reset(new Transcoder(std::move(recorded), std::move(loaded), encoding::describeDefaults(type, text)));
    return true;
}

std::string MessageDecoder::decode(const mcap::Message& message, void* value) {
    if (message.size < kHead || message.data[0] != 0 || message.data[1] > 1) return "byte 0: this is not plain CDR";
    encoding::ByteOrder order = message.data[1] == 1 ? encoding::ByteOrder::Little : encoding::ByteOrder::Big;
    const unsigned char* data = message.data + kHead;
    std::size_t size = message.size - kHead;
    if (transcoder_) {
        std::string why;
        if (!transcoder_->convert(data, size, order != encoding::kNativeOrder, bytes_, why)) return why;
        order = encoding::kNativeOrder;
        data = bytes_.data();
        size = bytes_.size();
    }
    encoding::DecodeError error = plan_->decode(data, size, order, value);
    // Some writers fill up the last word.
    if (error && error.offset != 0 && error.offset < size && size - error.offset < 4)
        if (const encoding::DecodeError again = plan_->decode(data, error.offset, order, value); !again) error = {};
    return error.text();
}

}  // namespace OCL::replay
