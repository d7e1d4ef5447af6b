// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/mqueue/TransportPlugin.hpp>

#include <rtt/transports/mqueue/detail/generic_transporter.hpp>

namespace RTT::mqueue {

bool MQLibPlugin::registerTransport(std::string type_name, types::TypeInfo* info) {
    return type_name != "unknown_t" && info->addProtocol(ORO_MQUEUE_PROTOCOL_ID, new detail::GenericTransporter());
}
std::string MQLibPlugin::getTransportName() const { return "mqueue"; }
std::string MQLibPlugin::getTypekitName() const { return "rtt-types"; }
std::string MQLibPlugin::getName() const { return "rtt-mqueue-transport"; }

}  // namespace RTT::mqueue
