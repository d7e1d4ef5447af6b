// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_TRANSPORT_PLUGIN_HPP
#define ORO_CORBA_TRANSPORT_PLUGIN_HPP

#include <rtt/types/TransportPlugin.hpp>

namespace RTT {
namespace corba {

/** Adds CORBA to every type, by its shape. */
struct RTT_API CorbaLibPlugin : public types::TransportPlugin {
    bool registerTransport(std::string type_name, types::TypeInfo* info) override;
    std::string getTransportName() const override;
    std::string getTypekitName() const override;
    std::string getName() const override;
};

}  // namespace corba
}  // namespace RTT

#endif
