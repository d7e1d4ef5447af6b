// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_SERVICE_SERVANT_HPP
#define ORO_CORBA_DETAIL_SERVICE_SERVANT_HPP

#include <rtt/transports/corba/detail/configuration_servant.hpp>
#include <rtt/transports/corba/detail/data_flow_servant.hpp>
#include <rtt/transports/corba/detail/operation_servant.hpp>

namespace RTT {
namespace corba {
namespace detail {

/** A service with all that it contains. */
class ServiceServant final : public virtual POA_RTT::corba::CService,
                             public OperationServant,
                             public ConfigurationServant,
                             public DataFlowServant {
public:
    ServiceServant(Served served, Service::shared_ptr service);

    char* getName() override;
    char* getServiceDescription() override;
    CServiceDescription* getCServiceDescription() override;
    corba::CService::CProviderNames* getProviderNames() override;
    CService_ptr getService(const char* name) override;
    CORBA::Boolean hasService(const char* name) override;
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
