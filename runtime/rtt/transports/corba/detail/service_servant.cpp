// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/service_servant.hpp>

#include <utility>

namespace RTT::corba::detail {

ServiceServant::ServiceServant(Served served, Service::shared_ptr service)
    : ServicePart(std::move(served), std::move(service)) {}

char* ServiceServant::getName() {
    const ServedComponent::Use use(*served_);
    return CORBA::string_dup(service_->getName().c_str());
}

char* ServiceServant::getServiceDescription() {
    const ServedComponent::Use use(*served_);
    return CORBA::string_dup(service_->doc().c_str());
}

CServiceDescription* ServiceServant::getCServiceDescription() {
    const ServedComponent::Use use(*served_);
    CServiceDescription_var made = new CServiceDescription();
    made->name = service_->getName().c_str();
    made->description = service_->doc().c_str();
    made->operations = corba::COperationInterface::COperationDescriptions_var(getOperations()).in();
    made->properties = corba::CConfigurationInterface::CPropertyNames_var(getPropertyList()).in();
    made->attributes = corba::CConfigurationInterface::CAttributeNames_var(getAttributeList()).in();
    made->ports = corba::CDataFlowInterface::CPortDescriptions_var(getPortDescriptions()).in();
    for (const std::string& name : service_->getProviderNames()) {
        const Service::shared_ptr child = service_->getService(name);
        if (!child || child == service_ || service_->getPort(name)) continue;  // the service of a port
        const CORBA::ULong index = made->children.length();
        made->children.length(index + 1);
        made->children_descriptions.length(index + 1);
        const CService_var reference = served_->reference(child);
        made->children[index] = reference;
        const CServiceDescription_var described = reference->getCServiceDescription();
        made->children_descriptions[index] = described.in();
    }
    return made._retn();
}

corba::CService::CProviderNames* ServiceServant::getProviderNames() {
    const ServedComponent::Use use(*served_);
    corba::CService::CProviderNames_var list = new corba::CService::CProviderNames();
    const Service::ProviderNames names = service_->getProviderNames();
    list->length(static_cast<CORBA::ULong>(names.size()));
    for (CORBA::ULong i = 0; i != list->length(); ++i) list[i] = names[i].c_str();
    return list._retn();
}

CService_ptr ServiceServant::getService(const char* name) {
    const ServedComponent::Use use(*served_);
    const Service::shared_ptr found = service_->getService(name);
    return found ? served_->reference(found) : corba::CService::_nil();
}

CORBA::Boolean ServiceServant::hasService(const char* name) {
    const ServedComponent::Use use(*served_);
    return service_->getService(name) != nullptr;
}

}  // namespace RTT::corba::detail
