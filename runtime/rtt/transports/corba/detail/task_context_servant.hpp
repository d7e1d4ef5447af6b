// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_TASK_CONTEXT_SERVANT_HPP
#define ORO_CORBA_DETAIL_TASK_CONTEXT_SERVANT_HPP

#include <rtt/transports/corba/TaskContextC.h>
#include <rtt/transports/corba/detail/served_component.hpp>

namespace RTT {
namespace corba {
namespace detail {

/** A component. */
class TaskContextServant final : public POA_RTT::corba::CTaskContext {
public:
    explicit TaskContextServant(Served served) : served_(std::move(served)) {}

    char* getName() override;
    char* getDescription() override;
    CTaskContextDescription* getCTaskContextDescription() override;
    CTaskState getTaskState() override;
    CORBA::Boolean configure() override;
    CORBA::Boolean start() override;
    CORBA::Boolean activate() override;
    CORBA::Boolean stop() override;
    CORBA::Boolean recover() override;
    CORBA::Boolean resetException() override;
    CORBA::Boolean cleanup() override;
    CORBA::Boolean isActive() override;
    CORBA::Boolean isRunning() override;
    CORBA::Boolean isConfigured() override;
    CORBA::Boolean inFatalError() override;
    CORBA::Boolean inRunTimeError() override;
    CORBA::Boolean inException() override;
    CDataFlowInterface_ptr ports() override;
    CService_ptr getProvider(const char* service_name) override;
    CServiceRequester_ptr getRequester(const char* service_name) override;
    RTT::corba::CTaskContext::CPeerNames* getPeerList() override;
    RTT::corba::CTaskContext_ptr getPeer(const char* name) override;
    CORBA::Boolean hasPeer(const char* name) override;
    CORBA::Boolean addPeer(CTaskContext_ptr p, const char* peer_alias) override;
    CORBA::Boolean removePeer(const char* name) override;
    CORBA::Boolean connectPeers(CTaskContext_ptr p) override;
    CORBA::Boolean disconnectPeers(const char* name) override;
    CORBA::Boolean connectPorts(CTaskContext_ptr p) override;
    CORBA::Boolean connectServices(CTaskContext_ptr p) override;

private:
    const Served served_;
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
