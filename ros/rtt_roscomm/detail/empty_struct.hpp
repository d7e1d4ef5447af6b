// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_DETAIL_EMPTY_STRUCT_HPP
#define RTT_ROSCOMM_DETAIL_EMPTY_STRUCT_HPP

#include <rtt/types/Shape.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

#include <algorithm>

namespace rtt_roscomm::detail {

/** Are the messages of a type without any byte? Such a type is a struct without fields, or one of such structs. Do not
    ask Plan::sizeOf() for that: it is also 0 for a value that cannot be encoded. */
inline bool isEmptyStruct(const RTT::types::TypeInfo& type) {
    const RTT::types::Shape shape = type.shape();
    // A field without an offset may be of any type, even of this one.
    return shape.kind == RTT::types::Shape::Kind::Struct &&
           std::all_of(shape.fields.begin(), shape.fields.end(), [](const RTT::types::Shape::Field& field) {
               const auto* const part = RTT::types::Types()->getTypeById(field.type);
               return part && !field.access && isEmptyStruct(*part);
           });
}

}  // namespace rtt_roscomm::detail

#endif
