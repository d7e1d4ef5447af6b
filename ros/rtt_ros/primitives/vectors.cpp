// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "primitives_typekit.hpp"

#include <rtt/types/TypekitSource.hpp>

#include <ros/time.h>

namespace rtt_ros {

namespace {

using RTT::types::TypeInfo;
using RTT::types::Types;

/** A type that has another name already, such as "array", gets one more, and keeps its factories. */
template <class C>
bool addVector(const char* name) {
    if (TypeInfo* known = Types()->getTypeInfo<C>()) return Types()->aliasType(name, known);
    return RTT::types::addType(RTT::types::makeSequenceType<C>(name));
}

template <class E>
bool addArray(const char* name) {
    if (TypeInfo* known = Types()->getArrayType(typeid(E).name())) return Types()->aliasType(name, known);
    return RTT::types::addType(RTT::types::makeArrayType<E>(name));
}

template <class E>
bool addBoth(const char* vector, const char* array) {
    return addVector<std::vector<E>>(vector) && addArray<E>(array);
}

}  // namespace

bool addVectors() {
    bool added = addBoth<std::int8_t>("int8[]", "cint8[]");
    added &= addBoth<std::uint8_t>("uint8[]", "cuint8[]");
    added &= addBoth<std::int16_t>("int16[]", "cint16[]");
    added &= addBoth<std::uint16_t>("uint16[]", "cuint16[]");
    added &= addBoth<std::int32_t>("int32[]", "cint32[]");
    added &= addBoth<std::uint32_t>("uint32[]", "cuint32[]");
    added &= addBoth<std::int64_t>("int64[]", "cint64[]");
    added &= addBoth<std::uint64_t>("uint64[]", "cuint64[]");
    added &= addBoth<float>("float32[]", "cfloat32[]");
    added &= addBoth<double>("float64[]", "cfloat64[]");
    added &= addBoth<std::string>("string[]", "cstring[]");
    added &= addBoth<ros::Time>("time[]", "ctime[]");
    added &= addBoth<ros::Duration>("duration[]", "cduration[]");
    return added;
}

}  // namespace rtt_ros
