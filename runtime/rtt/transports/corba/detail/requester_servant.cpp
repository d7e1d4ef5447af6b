// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/requester_servant.hpp>

#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/transports/corba/detail/remote_service.hpp>
#include <rtt/transports/corba/detail/served_components.hpp>

#include <utility>

namespace RTT::corba::detail {

namespace {

template <class List>
List* listOf(const std::vector<std::string>& names) {
    typename List::_var_type list = new List();
    list->length(static_cast<CORBA::ULong>(names.size()));
    for (CORBA::ULong i = 0; i != list->length(); ++i) list[i] = names[i].c_str();
    return list._retn();
}

/** The service itself if it is in this process; otherwise one that calls it. */
Service::shared_ptr serviceOf(CService_ptr reference) {
    if (CORBA::is_nil(reference)) return nullptr;
    const Service::shared_ptr near = servedService(reference);
    return near ? near : newRemoteService(reference);
}

}  // namespace

RequesterServant::RequesterServant(Served served, ServiceRequester::shared_ptr requester)
    : served_(std::move(served)), requester_(std::move(requester)) {}

char* RequesterServant::getRequestName() {
    const ServedComponent::Use use(*served_);
    return CORBA::string_dup(requester_->getRequestName().c_str());
}

CServiceRequesterDescription* RequesterServant::getCServiceRequesterDescription() {
    const ServedComponent::Use use(*served_);
    CServiceRequesterDescription_var made = new CServiceRequesterDescription();
    made->name = requester_->getRequestName().c_str();
    made->operationcallernames = COperationCallerNames_var(getOperationCallerNames()).in();
    for (const std::string& name : requester_->getRequesterNames()) {
        const CORBA::ULong index = made->children.length();
        made->children.length(index + 1);
        made->children_descriptions.length(index + 1);
        const CServiceRequester_var reference = served_->reference(requester_->requires_(name));
        made->children[index] = reference;
        const CServiceRequesterDescription_var described = reference->getCServiceRequesterDescription();
        made->children_descriptions[index] = described.in();
    }
    return made._retn();
}

CRequestNames* RequesterServant::getRequestNames() {
    const ServedComponent::Use use(*served_);
    return listOf<CRequestNames>(requester_->getRequesterNames());
}

COperationCallerNames* RequesterServant::getOperationCallerNames() {
    const ServedComponent::Use use(*served_);
    return listOf<COperationCallerNames>(requester_->getOperationCallerNames());
}

CServiceRequester_ptr RequesterServant::getRequest(const char* name) {
    const ServedComponent::Use use(*served_);
    return requester_->requiresService(name) ? served_->reference(requester_->requires_(name))
                                             : corba::CServiceRequester::_nil();
}

CORBA::Boolean RequesterServant::hasRequest(const char* name) {
    const ServedComponent::Use use(*served_);
    return requester_->requiresService(name);
}

CORBA::Boolean RequesterServant::connectTo(CService_ptr svc) {
    const ServedComponent::Use use(*served_);
    const Service::shared_ptr service = serviceOf(svc);
    return service && requester_->connectTo(service);
}

CORBA::Boolean RequesterServant::connectCallerTo(const char* name, CService_ptr svc) {
    const ServedComponent::Use use(*served_);
    base::OperationCallerBaseInvoker* const caller = requester_->getOperationCaller(name);
    const Service::shared_ptr service = caller ? serviceOf(svc) : nullptr;
    OperationInterfacePart* const part = service ? service->findOperation(name) : nullptr;
    return part && caller->setImplementationPart(part, served_->component().engine());
}

CORBA::Boolean RequesterServant::ready() {
    const ServedComponent::Use use(*served_);
    return requester_->ready();
}

CORBA::Boolean RequesterServant::disconnectCaller(const char* name) {
    const ServedComponent::Use use(*served_);
    base::OperationCallerBaseInvoker* const caller = requester_->getOperationCaller(name);
    if (caller) caller->disconnect();
    return caller != nullptr;
}

CORBA::Boolean RequesterServant::callerReady(const char* name) {
    const ServedComponent::Use use(*served_);
    const base::OperationCallerBaseInvoker* const caller = requester_->getOperationCaller(name);
    return caller && caller->ready();
}

void RequesterServant::disconnect() {
    const ServedComponent::Use use(*served_);
    requester_->disconnect();
}

}  // namespace RTT::corba::detail
