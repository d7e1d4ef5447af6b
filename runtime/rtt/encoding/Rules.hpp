// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENCODING_RULES_HPP
#define ORO_ENCODING_RULES_HPP

#include <rtt/rtt-config.h>

#include <cstddef>
#include <cstdint>

namespace RTT {
namespace encoding {

enum class ByteOrder : std::uint8_t { Big, Little };

/** That of this machine. */
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
constexpr ByteOrder kNativeOrder = ByteOrder::Big;
#else
constexpr ByteOrder kNativeOrder = ByteOrder::Little;
#endif

/** What distinguishes the binary encodings, all of which write the fields of a struct one after another and the number
    of elements, 4 bytes, in front of those of a container. */
struct Rules {
    /** Each number begins at a multiple of its size, at most of this many bytes, from the first byte; 1: anywhere. */
    std::uint8_t mostAligned;
    /** A text ends with a zero byte, which its length includes. */
    bool textEndsWithZero;
    /** Enumerators have 4 bytes; otherwise as many as the enum. */
    bool enumsHaveFourBytes;
    /** A struct without fields has one byte. */
    bool emptyStructHasByte;

    /** What the position of a number of `size` bytes is a multiple of. */
    constexpr std::uint8_t alignmentOf(std::size_t size) const {
        return size < mostAligned ? static_cast<std::uint8_t>(size) : mostAligned;
    }
};

/** Common Data Representation as in DDS and ROS 2 (XCDR version 1), without the header of 4 bytes and without the
    padding that some add at the end. */
constexpr Rules cdrRules() { return {8, true, false, true}; }
/** As in CORBA. */
constexpr Rules corbaRules() { return {8, true, true, false}; }
/** Messages of ROS 1. */
constexpr Rules ros1Rules() { return {1, false, false, false}; }

}  // namespace encoding
}  // namespace RTT

#endif
