// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// CDR in either byte order, number by number, straight from the shapes: what Plan must agree with.
#ifndef OROFORGE_TESTS_REFERENCE_CDR_HPP
#define OROFORGE_TESTS_REFERENCE_CDR_HPP

#include <cstddef>
#include <string>

#include <rtt/encoding/Rules.hpp>
#include <rtt/types/Shape.hpp>
#include <rtt/types/TypeInfo.hpp>

namespace oroforge::test {

class ReferenceCdr {
public:
    explicit ReferenceCdr(RTT::encoding::ByteOrder order) : order_(order) {}

    void put(const RTT::types::TypeInfo& type, const void* value);
    const std::string& bytes() const { return bytes_; }

private:
    void put(const char* type, const void* value);
    void putNumber(const void* value, std::size_t size);
    void putCount(std::size_t count);
    void putPart(const char* type, const RTT::types::SequenceOps& ops, const void* whole, std::size_t index);
    void putFields(const RTT::types::Shape& shape, const void* value);
    void putElements(const RTT::types::Shape& shape, const void* value);

    const RTT::encoding::ByteOrder order_;
    std::string bytes_;
};

}  // namespace oroforge::test

#endif
