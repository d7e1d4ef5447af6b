// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/DataSourceProxy.hpp>

#include <rtt/transports/corba/CorbaTypeTransporter.hpp>
#include <rtt/types/TypeInfo.hpp>

namespace RTT::corba {

const char* NonExistingDataSource::what() const noexcept {
    return "the other process has no such property or attribute of that type";
}

base::DataSourceBase::shared_ptr newProxyOfValue(CService_ptr service, const std::string& name, bool isProperty,
                                                 const types::TypeInfo& type) {
    auto* const transporter = type.hasProtocol(ORO_CORBA_PROTOCOL_ID)
                                  ? dynamic_cast<CorbaTypeTransporter*>(type.getProtocol(ORO_CORBA_PROTOCOL_ID))
                                  : nullptr;
    base::DataSourceBase::shared_ptr made;
    // Not the functions that override these: they may be what asks for this proxy.
    if (transporter)
        made = isProperty ? transporter->CorbaTypeTransporter::createPropertyDataSource(service, name)
                          : transporter->CorbaTypeTransporter::createAttributeDataSource(service, name, true);
    if (!made) throw NonExistingDataSource();
    return made;
}

}  // namespace RTT::corba
