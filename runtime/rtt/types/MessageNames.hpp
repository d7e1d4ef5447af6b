// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPES_MESSAGE_NAMES_HPP
#define ORO_TYPES_MESSAGE_NAMES_HPP

#include <rtt/rtt-config.h>

#include <functional>
#include <string>

namespace RTT {
namespace types {

/** A type whose values, encoded by their shape, are messages of another system, such as ROS. */
struct MessageName {
    std::string type;        ///< in the type registry: "/demo/Pose"
    std::string message;     ///< "geometry_msgs/Pose"
    std::string md5;         ///< by which the other system distinguishes versions of a message
    std::string definition;  ///< of the message, in the words of the other system
};

/**
 * Says which message a type is. Generated typekits call this before they register the type; it need not exist. False,
 * with an error in the log, if the type is another message already. Thread-safe, not real-time safe: it allocates, and
 * calls those that watch.
 */
RTT_API bool announceMessage(const char* type, const char* message, const char* md5, const char* definition);

/** The message that a type is, or null. It lives as long as the process. Thread-safe, waits for a mutex. */
RTT_API const MessageName* announcedMessage(const std::string& type);

/**
 * Calls `told` for each message that has been announced, in this thread, and for each later one, in the thread that
 * announces it: once for each, several at a time if several threads announce. It is called without a lock, for as long
 * as the process lives, so its code must not be unloaded. Thread-safe, not real-time safe.
 */
RTT_API void watchMessages(std::function<void(const MessageName&)> told);

}  // namespace types
}  // namespace RTT

#endif
