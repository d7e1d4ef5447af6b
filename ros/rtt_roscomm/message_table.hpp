// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_MESSAGE_TABLE_HPP
#define RTT_ROSCOMM_MESSAGE_TABLE_HPP

#include <rtt/types/TransportPlugin.hpp>

#include <cstddef>
#include <string>

namespace rtt_roscomm {

/** A message of ROS and the type of this runtime whose values, encoded by their shape, are such messages. Texts live as
    long as the process. */
struct MessageEntry {
    const char* type;        ///< in the type registry: "/geometry_msgs/Pose"
    const char* message;     ///< "geometry_msgs/Pose"
    const char* md5;         ///< 32 hexadecimal digits
    const char* definition;  ///< text of the .msg file, followed by those of the messages in it
};

/** A service of ROS. */
struct ServiceEntry {
    const char* service;   ///< "std_srvs/SetBool"
    const char* md5;       ///< 32 hexadecimal digits
    const char* request;   ///< in the type registry: "/std_srvs/SetBoolRequest"
    const char* response;  ///< "/std_srvs/SetBoolResponse"
};

/** Gives the types of one message package the transport of topics. A generated library rtt-<package>-ros-transport
    exports a subclass with its table. */
class MessageTransport : public RTT::types::TransportPlugin {
public:
    /** The table must live as long as the process. */
    MessageTransport(std::string package, const MessageEntry* first, std::size_t count);

    bool registerTransport(std::string type_name, RTT::types::TypeInfo* info) override;
    std::string getTransportName() const override;  ///< "ros"
    std::string getTypekitName() const override;    ///< "ros-<package>"
    std::string getName() const override;           ///< "rtt-ros-<package>-transport"

private:
    const std::string package_;
    const MessageEntry* const first_;
    const std::size_t count_;
};

/** Gives the transport of topics to all types that typekits announce as messages (rtt/types/MessageNames.hpp), now and
    later. Loading the plugin rostopic calls this. Thread-safe; calls after the first do nothing. */
void serveAnnouncedMessages();

/** Makes the services of one message package known to rosservice_registry. A generated plugin rtt_<package>_rosservice_proxies
    calls this when it is loaded. The table must live as long as the process. Thread-safe. */
void addServices(const ServiceEntry* first, std::size_t count);

}  // namespace rtt_roscomm

#endif
