// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_SERVICE_CODEC_HPP
#define RTT_ROSCOMM_SERVICE_CODEC_HPP

#include <rtt/base/DataSourceBase.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <typeinfo>

namespace RTT {
namespace types {
class TypeInfo;
}
}  // namespace RTT

namespace rtt_roscomm {

/** The request or the response of a service: the C++ type of its values, and their bytes on the wire. A constant that any
    number of threads may use. Nothing here is real-time safe. */
class MessageCodec {
public:
    virtual ~MessageCodec();
    virtual const std::type_info& type() const = 0;
    /** In the type registry; null if it is not there. */
    virtual const RTT::types::TypeInfo* info() const = 0;
    /** A new variable with the default value. */
    virtual RTT::base::DataSourceBase::shared_ptr makeVariable() const = 0;
    /** Assigns the default value. */
    virtual void clear(void* value) const = 0;

    // They throw std::exception if the value, or the bytes, are wrong.
    virtual std::size_t size(const void* value) const = 0;
    /** `room` is what size() gave. */
    virtual void encode(const void* value, std::uint8_t* to, std::size_t room) const = 0;
    virtual void decode(const std::uint8_t* from, std::size_t size, void* value) const = 0;

    /** The name in the type registry, or that of C++. */
    std::string typeName() const;
};
typedef std::shared_ptr<const MessageCodec> Codec;

/** For a type by its name in the type registry. Null, with the reason, if it is unknown or has no shape. */
Codec registeredCodec(const std::string& type, std::string& why);

}  // namespace rtt_roscomm

#endif
