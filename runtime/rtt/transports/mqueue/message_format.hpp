// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MQUEUE_MESSAGE_FORMAT_HPP
#define ORO_MQUEUE_MESSAGE_FORMAT_HPP

#include <rtt/rtt-config.h>

#include <cstddef>
#include <memory>
#include <string>

namespace RTT {
namespace mqueue {

/** How one channel writes the samples of its type into messages. Used by one thread at a time. */
class RTT_API MessageFormat {
public:
    virtual ~MessageFormat();

    /** The bytes of a message with this sample; 0 if there can be none. Real-time safe, as are the other two if they
        succeed and the containers of the sample are large enough. */
    virtual std::size_t sizeOf(const void* sample) const = 0;
    /** Writes the message and returns its size; 0 if `room` bytes are not enough, or if there can be none. */
    virtual std::size_t write(const void* sample, void* to, std::size_t room) const = 0;
    /** Sets the sample. False, with the reason in `why`, if these bytes are no message of this format. */
    virtual bool read(const void* from, std::size_t size, void* sample, std::string& why) const = 0;

    /** The message of a sample is its memory, and sizeOf() is the same for all. */
    virtual bool isMemory() const { return false; }
    /** All messages have the same size. */
    virtual bool hasFixedSize() const = 0;
    /** The other end may be a program of the original toolchain, whose first message has no mark. */
    virtual bool isOfOriginal() const { return true; }
};

/** The `size` bytes of the sample. */
RTT_API std::unique_ptr<MessageFormat> newMemoryFormat(std::size_t size);

}  // namespace mqueue
}  // namespace RTT

#endif
