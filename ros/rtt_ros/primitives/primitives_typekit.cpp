// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "primitives_typekit.hpp"

#include <rtt/types/TemplateConstructor.hpp>
#include <rtt/types/TypekitSource.hpp>

#include <ros/time.h>

#include <cmath>
#include <stdexcept>

ORO_MAKE_SAMPLE(ros::Time)
ORO_MAKE_SAMPLE(ros::Duration)

namespace rtt_ros {

namespace {

using RTT::types::Member;
using RTT::types::TypeInfo;
using RTT::types::Types;
using RTT::types::typeRef;

constexpr Member timeMembers[] = {
    {"sec", __builtin_offsetof(ros::Time, sec), &typeRef<std::uint32_t>, 0, "Seconds since 1970", "s"},
    {"nsec", __builtin_offsetof(ros::Time, nsec), &typeRef<std::uint32_t>, 0, "And nanoseconds", "ns"},
};
constexpr Member durationMembers[] = {
    {"sec", __builtin_offsetof(ros::Duration, sec), &typeRef<std::int32_t>, 0, "Seconds", "s"},
    {"nsec", __builtin_offsetof(ros::Duration, nsec), &typeRef<std::int32_t>, 0, "And nanoseconds", "ns"},
};

template <class T>
bool alias(const char* name) {
    return Types()->aliasType(name, Types()->getTypeInfo<T>());
}

/** Throws for seconds that no time has; evaluation of the script fails then. */
ros::Time timeOf(double seconds) {
    if (!(seconds >= 0 && seconds < 4294967296.0)) throw std::out_of_range("time(): not from 0 to 2^32 seconds");
    return ros::Time(seconds);
}
ros::Duration durationOf(double seconds) {
    if (!(std::fabs(seconds) < 2147483648.0)) throw std::out_of_range("duration(): not within 2^31 seconds");
    return ros::Duration(seconds);
}

}  // namespace

bool PrimitivesTypekit::loadTypes() {
    // int8 to uint16, int64 and uint64 are types of the runtime.
    bool added = alias<std::int32_t>("int32") && alias<std::uint32_t>("uint32");
    added &= alias<float>("float32") && alias<double>("float64");
    added &= RTT::types::addType(RTT::types::makeStructType<ros::Time>("time", timeMembers, 2, "A time of ROS"));
    added &= RTT::types::addType(
        RTT::types::makeStructType<ros::Duration>("duration", durationMembers, 2, "A duration of ROS"));
    return addVectors() && added;
}

bool PrimitivesTypekit::loadConstructors() {
    Types()->getTypeInfo<ros::Time>()->addConstructor(RTT::types::newConstructor(&timeOf, true));
    Types()->getTypeInfo<ros::Duration>()->addConstructor(RTT::types::newConstructor(&durationOf, true));
    return true;
}

}  // namespace rtt_ros

ORO_TYPEKIT_PLUGIN(rtt_ros::PrimitivesTypekit)
