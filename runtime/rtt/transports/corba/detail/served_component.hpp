// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_SERVED_COMPONENT_HPP
#define ORO_CORBA_DETAIL_SERVED_COMPONENT_HPP

#include <rtt/Service.hpp>
#include <rtt/ServiceRequester.hpp>
#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/transports/corba/ServiceC.h>
#include <rtt/transports/corba/ServiceRequesterC.h>
#include <rtt/transports/corba/corba.h>

#include <chrono>
#include <map>
#include <memory>
#include <mutex>

namespace RTT {
class TaskContext;
namespace corba {
namespace detail {

/**
 * A component of this process that others can call, and the objects that represent its parts. They are made when
 * somebody asks for them. The component may be destroyed at any moment: calls fail from then on.
 */
class ServedComponent : public std::enable_shared_from_this<ServedComponent> {
public:
    explicit ServedComponent(TaskContext& component);
    ~ServedComponent();
    ServedComponent(const ServedComponent&) = delete;
    ServedComponent& operator=(const ServedComponent&) = delete;

    /** While one exists, the component is not destroyed. Throws CORBA::OBJECT_NOT_EXIST if it was. */
    class Use {
    public:
        explicit Use(const ServedComponent& served) : visit_(*served.gate_) {
            if (!visit_.engine()) throw CORBA::OBJECT_NOT_EXIST();
        }

    private:
        const internal::EngineGate::Visit visit_;
    };

    /** Only within a Use. */
    TaskContext& component() const { return component_; }
    bool isGone() const { return gate_->closed(); }

    /** Makes a servant callable; the adapter owns it from then on. The caller owns the reference. */
    template <class Interface>
    typename Interface::_ptr_type activate(PortableServer::ServantBase* servant) {
        const PortableServer::ServantBase_var owned(servant);
        const PortableServer::ObjectId_var id = adapter_->activate_object(servant);
        const CORBA::Object_var object = adapter_->id_to_reference(id);
        return Interface::_narrow(object);
    }
    /** Ends an object that was kept. */
    void deactivate(PortableServer::ServantBase* servant);
    /** For an object that its user disposes of, if that is not killed before: it was used now. Those that were not used
        for an hour are deactivated. */
    void keep(PortableServer::ServantBase* servant);
    /** The caller owns the references. */
    CService_ptr reference(const Service::shared_ptr& service);
    CServiceRequester_ptr reference(const ServiceRequester::shared_ptr& requester);
    /** The service behind a reference; null if it is none of this component. */
    Service::shared_ptr find(CORBA::Object_ptr reference);

    /** No part can be called any more. Calls in progress go on. */
    void close();

private:
    TaskContext& component_;
    const boost::intrusive_ptr<const internal::EngineGate> gate_;
    PortableServer::POA_var adapter_;
    std::mutex mutex_;  // guards all below
    std::map<PortableServer::ServantBase*, std::chrono::steady_clock::time_point> kept_;
    std::map<Service::shared_ptr, CService_var> services_;
    std::map<ServiceRequester::shared_ptr, CServiceRequester_var> requesters_;
};

typedef std::shared_ptr<ServedComponent> Served;

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
