// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/CorbaTypeTransporter.hpp>

#include <rtt/Logger.hpp>
#include <rtt/transports/corba/detail/any_values.hpp>
#include <rtt/transports/corba/detail/lone_service.hpp>
#include <rtt/transports/corba/detail/remote_value.hpp>
#include <rtt/types/Types.hpp>

#include <memory>

namespace RTT::corba {

namespace {

using detail::RemoteAccess;

base::DataSourceBase::shared_ptr newRemoteValue(const CorbaTypeTransporter& transporter, CService_ptr service,
                                                RemoteAccess::Kind kind, const std::string& name, bool assignable) {
    if (CORBA::is_nil(service)) return nullptr;
    try {
        const CORBA::String_var typeName = kind == RemoteAccess::Kind::Property
                                               ? service->getPropertyTypeName(name.c_str())
                                               : service->getAttributeTypeName(name.c_str());
        const types::TypeInfo* const type = types::Types()->type(typeName.in());
        if (!type || detail::transporterOf(*type) != &transporter) return nullptr;
        const CORBA::String_var owner = service->getName();
        const std::shared_ptr<detail::LoneService> peer = detail::LoneService::of(service, owner.in());
        return detail::newRemoteValue(*type, {peer, peer->reference(), kind, name}, assignable);
    } catch (const CORBA::Exception& error) {
        log(Error) << "no access to '" << name << "' of another process: " << detail::describe(error) << endlog();
        return nullptr;
    }
}

}  // namespace

CRemoteChannelElement_i* CorbaTypeTransporter::createChannelElement_i(DataFlowInterface*, PortableServer::POA_ptr,
                                                                      const ConnPolicy&) const {
    return nullptr;
}

base::DataSourceBase::shared_ptr CorbaTypeTransporter::createPropertyDataSource(CService_ptr service,
                                                                                const std::string& name) {
    return newRemoteValue(*this, service, RemoteAccess::Kind::Property, name, true);
}

base::DataSourceBase::shared_ptr CorbaTypeTransporter::createAttributeDataSource(CService_ptr service,
                                                                                 const std::string& name,
                                                                                 bool assignable) {
    return newRemoteValue(*this, service, RemoteAccess::Kind::Attribute, name, assignable);
}

}  // namespace RTT::corba
