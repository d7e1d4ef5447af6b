// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A message for roscpp that is a sample and its format.
#ifndef RTT_ROSCOMM_RAW_MESSAGE_HPP
#define RTT_ROSCOMM_RAW_MESSAGE_HPP

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <rtt_roscomm/message_format.hpp>

#include <cstring>
#include <stdexcept>

namespace rtt_roscomm {

struct RawMessage {
    const MessageFormat* format;  // null: the sample is the bytes of the message
    const void* sample;
    std::size_t size;  // from MessageFormat::sizeOf()
};

}  // namespace rtt_roscomm

namespace ros {
namespace message_traits {
/** "*" fits each topic: the topic was advertised with the names of the format. */
template <>
struct MD5Sum<rtt_roscomm::RawMessage> {
    static const char* value() { return "*"; }
    static const char* value(const rtt_roscomm::RawMessage&) { return "*"; }
};
template <>
struct DataType<rtt_roscomm::RawMessage> {
    static const char* value() { return "*"; }
    static const char* value(const rtt_roscomm::RawMessage&) { return "*"; }
};
}  // namespace message_traits
namespace serialization {
template <>
struct Serializer<rtt_roscomm::RawMessage> {
    template <class Stream>
    static void write(Stream& stream, const rtt_roscomm::RawMessage& message) {
        const std::uint32_t size = static_cast<std::uint32_t>(message.size);
        std::uint8_t* const to = stream.advance(size);
        if (!message.format)
            std::memcpy(to, message.sample, size);
        else if (!message.format->write(message.sample, to, size))
            throw std::length_error("the sample changed while it was encoded");
    }
    static std::uint32_t serializedLength(const rtt_roscomm::RawMessage& message) {
        return static_cast<std::uint32_t>(message.size);
    }
};
}  // namespace serialization
}  // namespace ros

#endif
