// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/TransportPlugin.hpp>

#include <rtt/transports/corba/CorbaTemplateProtocol.hpp>
#include <rtt/transports/corba/detail/generic_transporter.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <typeinfo>

namespace RTT::corba {

namespace {

CorbaTypeTransporter* newTransporter(const types::TypeInfo& type) {
    const types::TypeInfo::TypeId id = type.getTypeId();
    if (id && *id == typeid(ConnPolicy)) return new CorbaTemplateProtocol<ConnPolicy>();
    if (id && *id == typeid(TaskContext*)) return new CorbaTemplateProtocol<TaskContext*>();
    return new detail::GenericTransporter(type);
}

}  // namespace

bool CorbaLibPlugin::registerTransport(std::string type_name, types::TypeInfo* info) {
    return type_name != "unknown_t" && info->addProtocol(ORO_CORBA_PROTOCOL_ID, newTransporter(*info));
}
std::string CorbaLibPlugin::getTransportName() const { return "CORBA"; }
std::string CorbaLibPlugin::getTypekitName() const { return "rtt-types"; }
std::string CorbaLibPlugin::getName() const { return "rtt-corba-types"; }

}  // namespace RTT::corba
