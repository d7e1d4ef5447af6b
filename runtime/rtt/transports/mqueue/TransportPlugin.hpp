// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MQ_TRANSPORT_PLUGIN_HPP
#define ORO_MQ_TRANSPORT_PLUGIN_HPP

#include <rtt/types/TransportPlugin.hpp>

namespace RTT {
namespace mqueue {

/** Adds POSIX message queues to every type, by its shape. */
struct RTT_API MQLibPlugin : public types::TransportPlugin {
    bool registerTransport(std::string type_name, types::TypeInfo* info) override;
    std::string getTransportName() const override;
    std::string getTypekitName() const override;
    std::string getName() const override;
};

}  // namespace mqueue
}  // namespace RTT

#endif
