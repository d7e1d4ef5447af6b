// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_DATA_FLOW_SERVANT_HPP
#define ORO_CORBA_DETAIL_DATA_FLOW_SERVANT_HPP

#include <rtt/transports/corba/detail/service_part.hpp>

#include <string>

namespace RTT {
namespace base {
class InputPortInterface;
class OutputPortInterface;
class PortInterface;
}  // namespace base
namespace corba {
namespace detail {

/** The ports of a service. */
class DataFlowServant : public virtual POA_RTT::corba::CDataFlowInterface, protected virtual ServicePart {
public:
    /** ServiceServant makes the ServicePart. */
    DataFlowServant() : ServicePart(nullptr, nullptr) {}

    corba::CDataFlowInterface::CPortNames* getPorts() override;
    corba::CDataFlowInterface::CPortDescriptions* getPortDescriptions() override;
    CPortType getPortType(const char* port_name) override;
    char* getDataType(const char* port_name) override;
    CORBA::Boolean isConnected(const char* port_name) override;
    void disconnectPort(const char* port_name) override;
    CChannelElement_ptr buildChannelOutput(const char* input_port, CConnPolicy& policy) override;
    CChannelElement_ptr buildChannelInput(const char* output_port, CConnPolicy& policy) override;
    CORBA::Boolean createConnection(const char* local_port, CDataFlowInterface_ptr remote_ports,
                                    const char* remote_port, CConnPolicy& policy) override;
    CORBA::Boolean createSharedConnection(const char* input_port, CConnPolicy& policy) override;
    CORBA::Boolean removeConnection(const char* local_port, CDataFlowInterface_ptr remote_ports,
                                    const char* remote_port) override;
    CORBA::Boolean createStream(const char* local_port, CConnPolicy& policy) override;
    void removeStream(const char* local_port, const char* stream_name) override;

private:
    // These throw CNoSuchPortException.
    base::PortInterface& port(const std::string& name) const;
    base::InputPortInterface& inputPort(const std::string& name) const;
    base::OutputPortInterface& outputPort(const std::string& name) const;
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
