// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_MESSAGE_FORMAT_HPP
#define RTT_ROSCOMM_MESSAGE_FORMAT_HPP

#include <cstddef>
#include <memory>
#include <string>

namespace RTT {
namespace types {
class TypeInfo;
}
}  // namespace RTT

namespace rtt_roscomm {

struct MessageEntry;

/** How the samples of one type become the messages of a topic. Any number of threads may use it at once. */
class MessageFormat {
public:
    virtual ~MessageFormat() = default;

    virtual std::string message() const = 0;  ///< "geometry_msgs/Pose"
    virtual std::string md5() const = 0;
    virtual std::string definition() const = 0;
    /** Its first field is the header, in which roscpp counts the messages. */
    virtual bool hasHeader() const = 0;

    /** The number of bytes of the message of this sample. False if there is none, see encoding::Plan::sizeOf(). */
    virtual bool sizeOf(const void* sample, std::size_t& size) const = 0;
    /** Writes that many bytes; false if the sample has changed since. */
    virtual bool write(const void* sample, void* to, std::size_t size) const = 0;
    /** Sets the sample; false, with the reason in `why`, if these bytes are no such message. */
    virtual bool read(const void* from, std::size_t size, void* sample, std::string& why) const = 0;
};

/** For the samples of a type, by its shape. A type of numbers in a row, such as "array", goes with a MultiArray of one
    dimension. Null, with the reason in `why`, if the type has no shape. */
std::shared_ptr<const MessageFormat> newMessageFormat(const RTT::types::TypeInfo& type, const MessageEntry& entry,
                                                      std::string& why);

}  // namespace rtt_roscomm

#endif
