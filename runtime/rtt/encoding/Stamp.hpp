// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENCODING_STAMP_HPP
#define ORO_ENCODING_STAMP_HPP

#include <rtt/rtt-config.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace RTT {
namespace types {
class TypeInfo;
}

namespace encoding {

/**
 * When a value was made: the first of its fields whose comment has the word `@stamp`. The field is an integer of 64
 * bits, nanoseconds, or a struct with the seconds (sec, secs, seconds or tv_sec) and the nanoseconds (nanosec, nsec,
 * nsecs, nanoseconds or tv_nsec), integers of 32 or 64 bits. It may be within other structs, but not within an array,
 * sequence or variant.
 */
class RTT_API Stamp {
public:
    /** Null if no field is marked so. Null, with the reason in `why`, if the field is not such a time. Allocates. */
    static std::unique_ptr<const Stamp> make(const types::TypeInfo& type, std::string& why);

    /** The time in nanoseconds; 0 if it is negative or larger than 64 bits. Real-time safe. */
    std::uint64_t read(const void* value) const;

private:
    struct Part {
        std::size_t offset = 0;
        std::uint8_t size = 0;  // bytes; 0: there is none
        bool isUnsigned = false;
    };
    std::int64_t numberAt(const Part& part, const void* value) const;

    Part seconds_, nanoseconds_;
    friend class StampFinder;
};

}  // namespace encoding
}  // namespace RTT

#endif
