// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What generated typekits of messages have in common.
#ifndef RTT_ROS_MESSAGE_TYPEKIT_HPP
#define RTT_ROS_MESSAGE_TYPEKIT_HPP

#include <rtt/rtt-config.h>

#include <cstddef>

namespace rtt_ros {

/**
 * Loads the typekit of another message package, rtt_<package>, unless it is loaded; for null only the types of numbers,
 * strings and times. If it is not found, the log has a warning that says what to do: fields with types of that package
 * have no value until it is imported. Thread-safe; may block, not real-time.
 */
RTT_EXPORT void needTypes(const char* package);

/** A constant of a message. Texts live as long as the process. */
struct MessageConstant {
    const char* name;   ///< "sensor_msgs.NavSatStatus.STATUS_FIX"
    const char* type;   ///< as the .msg file has it: "int8"
    const char* value;  ///< likewise: "0"
};

/** Makes constants visible in scripts. A name that is a global attribute already stays what it is. Not thread-safe, as
    the globals are not. */
RTT_EXPORT void addConstants(const MessageConstant* first, std::size_t count);

}  // namespace rtt_ros

#endif
