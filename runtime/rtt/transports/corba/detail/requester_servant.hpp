// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_REQUESTER_SERVANT_HPP
#define ORO_CORBA_DETAIL_REQUESTER_SERVANT_HPP

#include <rtt/transports/corba/detail/served_component.hpp>

namespace RTT {
namespace corba {
namespace detail {

/** What a component requires under one name. */
class RequesterServant final : public POA_RTT::corba::CServiceRequester {
public:
    RequesterServant(Served served, ServiceRequester::shared_ptr requester);

    char* getRequestName() override;
    CServiceRequesterDescription* getCServiceRequesterDescription() override;
    CRequestNames* getRequestNames() override;
    COperationCallerNames* getOperationCallerNames() override;
    CServiceRequester_ptr getRequest(const char* name) override;
    CORBA::Boolean hasRequest(const char* name) override;
    CORBA::Boolean connectTo(CService_ptr svc) override;
    CORBA::Boolean connectCallerTo(const char* name, CService_ptr svc) override;
    CORBA::Boolean ready() override;
    CORBA::Boolean disconnectCaller(const char* name) override;
    CORBA::Boolean callerReady(const char* name) override;
    void disconnect() override;

private:
    const Served served_;
    const ServiceRequester::shared_ptr requester_;
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
