// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/served_component.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/transports/corba/ApplicationServer.hpp>
#include <rtt/transports/corba/detail/requester_servant.hpp>
#include <rtt/transports/corba/detail/service_servant.hpp>

#include <atomic>
#include <string>
#include <vector>

namespace RTT::corba::detail {

namespace {

constexpr std::chrono::hours kForgotten{1};

/** An adapter for one component, so that all of its objects end together. */
PortableServer::POA_ptr newAdapter() {
    static std::atomic<unsigned> made{0};
    const PortableServer::POAManager_var manager = ApplicationServer::rootPOA->the_POAManager();
    const CORBA::PolicyList none;
    return ApplicationServer::rootPOA->create_POA(("component" + std::to_string(++made)).c_str(), manager, none);
}

}  // namespace

ServedComponent::ServedComponent(TaskContext& component)
    : component_(component), gate_(component.engine()->gate()), adapter_(newAdapter()) {}

ServedComponent::~ServedComponent() { close(); }

void ServedComponent::deactivate(PortableServer::ServantBase* servant) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (CORBA::is_nil(adapter_)) return;
    if (kept_.erase(servant) == 0) return;  // another thread does that
    const PortableServer::ObjectId_var id = adapter_->servant_to_id(servant);
    adapter_->deactivate_object(id);
}

void ServedComponent::keep(PortableServer::ServantBase* servant) {
    const auto now = std::chrono::steady_clock::now();
    std::vector<PortableServer::ServantBase*> forgotten;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        kept_[servant] = now;
        for (const auto& [known, used] : kept_)
            if (now - used > kForgotten) forgotten.push_back(known);
    }
    for (PortableServer::ServantBase* const one : forgotten) deactivate(one);
}

CService_ptr ServedComponent::reference(const Service::shared_ptr& service) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (CORBA::is_nil(adapter_)) throw CORBA::OBJECT_NOT_EXIST();
    CService_var& known = services_[service];
    if (CORBA::is_nil(known)) known = activate<CService>(new ServiceServant(shared_from_this(), service));
    return CService::_duplicate(known);
}

CServiceRequester_ptr ServedComponent::reference(const ServiceRequester::shared_ptr& requester) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (CORBA::is_nil(adapter_)) throw CORBA::OBJECT_NOT_EXIST();
    CServiceRequester_var& known = requesters_[requester];
    if (CORBA::is_nil(known)) known = activate<CServiceRequester>(new RequesterServant(shared_from_this(), requester));
    return CServiceRequester::_duplicate(known);
}

Service::shared_ptr ServedComponent::find(CORBA::Object_ptr reference) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& [service, known] : services_)
        if (known->_is_equivalent(reference)) return service;
    return nullptr;
}

void ServedComponent::close() {
    PortableServer::POA_var adapter;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        adapter = adapter_._retn();
        kept_.clear();
        services_.clear();
        requesters_.clear();
    }
    try {
        if (!CORBA::is_nil(adapter)) adapter->destroy(true, false);
    } catch (const CORBA::Exception&) {
        // The ORB was shut down, and all objects with it.
    }
}

}  // namespace RTT::corba::detail
