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
    /** An enumerator is its place in the list of all names in byte order, 4 bytes; otherwise, and if the enum has no
        names, its value, with as many bytes as the enum. */
    bool enumsByRank;
    /** A text has no zero bytes: it ends at the first one. */
    bool textEndsAtZero;
    /** A struct without fields has one byte. */
    bool emptyStructHasByte;

    /** What the position of a number of `size` bytes is a multiple of. */
    constexpr std::uint8_t alignmentOf(std::size_t size) const {
        return size < mostAligned ? static_cast<std::uint8_t>(size) : mostAligned;
    }
};

/** Common Data Representation as in DDS and ROS 2 (XCDR version 1), without the header of 4 bytes and without the
    padding that some add at the end. */
constexpr Rules cdrRules() { return {8, true, false, false, true}; }
/** As in CORBA. A struct without fields, which IDL does not have, is one with an octet. */
constexpr Rules corbaRules() { return {8, true, true, true, true}; }
/** Messages of ROS 1. */
constexpr Rules ros1Rules() { return {1, false, false, false, false}; }

}  // namespace encoding
}  // namespace RTT

#endif
