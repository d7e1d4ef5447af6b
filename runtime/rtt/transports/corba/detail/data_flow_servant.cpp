// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/data_flow_servant.hpp>

#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/ConnFactory.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/SharedConnection.hpp>
#include <rtt/transports/corba/CorbaConnPolicy.hpp>
#include <rtt/transports/corba/RemoteConnID.hpp>
#include <rtt/transports/corba/RemotePorts.hpp>
#include <rtt/transports/corba/detail/any_values.hpp>
#include <rtt/transports/corba/detail/expected_channel.hpp>
#include <rtt/transports/corba/detail/policies.hpp>
#include <rtt/transports/corba/detail/remote_channel.hpp>
#include <rtt/transports/corba/detail/served_components.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <memory>
#include <utility>

namespace RTT::corba::detail {

namespace {

using base::InputPortInterface;
using base::OutputPortInterface;
using base::PortInterface;

ConnPolicy policyOf(const CConnPolicy& given) { return completed(toRTT(given)); }

/** A connection with a port of which only the channel is known. */
internal::ConnID* newId() { return new RemoteConnID(corba::CDataFlowInterface::_nil(), ""); }

/** Throws CNoCorbaTransport. */
const types::TypeInfo& typeOf(const PortInterface& port) {
    const types::TypeInfo* const type = port.getTypeInfo();
    if (!type || !transporterOf(*type)) throw CNoCorbaTransport();
    return *type;
}

RemoteChannel::Pointer newChannel(RemoteChannel::End end, const PortInterface& port, const ConnPolicy& policy) {
    const RemoteChannel::Pointer made = RemoteChannel::make(end, typeOf(port), policy, port.getFullName());
    if (!made) throw CNoCorbaTransport();
    return made;
}

void describe(CPortDescription& described, PortInterface& port) {
    described.type = port.asInput() ? CInput : COutput;
    described.name = port.getName().c_str();
    described.description = port.getDescription().c_str();
    described.type_name = port.getTypeInfo() ? port.getTypeInfo()->getTypeName().c_str() : "unknown_t";
}

}  // namespace

DataFlowServant::DataFlowServant(Served served, Service::shared_ptr service)
    : served_(std::move(served)), service_(std::move(service)) {}

PortInterface& DataFlowServant::port(const std::string& name) const {
    PortInterface* const found = service_->getPort(name);
    if (!found) throw CNoSuchPortException();
    return *found;
}

InputPortInterface& DataFlowServant::inputPort(const std::string& name) const {
    InputPortInterface* const found = port(name).asInput();
    if (!found) throw CNoSuchPortException();
    return *found;
}

OutputPortInterface& DataFlowServant::outputPort(const std::string& name) const {
    OutputPortInterface* const found = port(name).asOutput();
    if (!found) throw CNoSuchPortException();
    return *found;
}

corba::CDataFlowInterface::CPortNames* DataFlowServant::getPorts() {
    const ServedComponent::Use use(*served_);
    corba::CDataFlowInterface::CPortNames_var list = new corba::CDataFlowInterface::CPortNames();
    const std::vector<std::string> names = service_->getPortNames();
    list->length(static_cast<CORBA::ULong>(names.size()));
    for (CORBA::ULong i = 0; i != list->length(); ++i) list[i] = names[i].c_str();
    return list._retn();
}

corba::CDataFlowInterface::CPortDescriptions* DataFlowServant::getPortDescriptions() {
    const ServedComponent::Use use(*served_);
    corba::CDataFlowInterface::CPortDescriptions_var list = new corba::CDataFlowInterface::CPortDescriptions();
    for (PortInterface* const one : service_->getPorts()) {
        const CORBA::ULong index = list->length();
        list->length(index + 1);
        describe(list[index], *one);
    }
    return list._retn();
}

CPortType DataFlowServant::getPortType(const char* port_name) {
    const ServedComponent::Use use(*served_);
    return port(port_name).asInput() ? CInput : COutput;
}

char* DataFlowServant::getDataType(const char* port_name) {
    const ServedComponent::Use use(*served_);
    const types::TypeInfo* const type = port(port_name).getTypeInfo();
    return CORBA::string_dup(type ? type->getTypeName().c_str() : "unknown_t");
}

CORBA::Boolean DataFlowServant::isConnected(const char* port_name) {
    const ServedComponent::Use use(*served_);
    return port(port_name).connected();
}

void DataFlowServant::disconnectPort(const char* port_name) {
    const ServedComponent::Use use(*served_);
    port(port_name).disconnect();
}

// The connection begins to exist when the other end says that it is ready.
CChannelElement_ptr DataFlowServant::buildChannelOutput(const char* input_port, CConnPolicy& policy) {
    const ServedComponent::Use use(*served_);
    InputPortInterface& input = inputPort(input_port);
    const ConnPolicy wanted = policyOf(policy);
    if (isOutOfBand(wanted) && !typeOf(input).hasProtocol(wanted.transport)) return CChannelElement::_nil();
    if (isOutOfBand(wanted) && wanted.name_id.empty()) {
        // The writer asks for the name.
        if (!input.createStream(wanted)) throw CInvalidArgument();
        policy = toCORBA(wanted);
        return newChannel(RemoteChannel::End::Reader, input, wanted)->reference();
    }
    base::ChannelElementBase::shared_ptr last;
    if (!isOutOfBand(wanted) && !wanted.pull) {
        last = internal::ConnFactory::makeChannelOutput(input, ofOneConnection(wanted));
        if (!last) throw CInvalidArgument();
    }
    const RemoteChannel::Pointer channel = newChannel(RemoteChannel::End::Reader, input, wanted);
    const ExpectedChannel::Known expected = ExpectedChannel::of(input, wanted.name_id, isOutOfBand(wanted));
    channel->whenEnded(expected.ended);
    if (isOutOfBand(wanted)) {
        channel->whenReady([served = served_, service = service_, name = std::string(input_port), wanted, channel,
                            id = expected.id] {
            const ServedComponent::Use inside(*served);
            PortInterface* const port = service->getPort(name);
            std::unique_ptr<internal::ConnID> own(id ? id->clone() : new internal::StreamConnID(wanted.name_id));
            const bool isMade = port && port->asInput() &&
                                internal::ConnFactory::createStream(*port->asInput(), wanted, std::move(own), channel);
            if (!isMade) channel->leave();
            return isMade;
        });
        return channel->reference();
    }
    channel->connectTo(last ? last : base::ChannelElementBase::shared_ptr(input.getEndpoint()));
    if (!last) last = channel;
    channel->whenReady(
        [served = served_, service = service_, name = std::string(input_port), wanted, last, id = expected.id] {
            const ServedComponent::Use inside(*served);
            PortInterface* const port = service->getPort(name);
            return port && port->asInput() && port->asInput()->channelReady(last, wanted, id ? id->clone() : newId());
        });
    return channel->reference();
}

// For others than ports: they read the returned object.
CChannelElement_ptr DataFlowServant::buildChannelInput(const char* output_port, CConnPolicy& policy) {
    const ServedComponent::Use use(*served_);
    OutputPortInterface& output = outputPort(output_port);
    ConnPolicy wanted = policyOf(policy);
    if (isOutOfBand(wanted)) {
        if (!typeOf(output).hasProtocol(wanted.transport)) throw CNoCorbaTransport();
        if (!output.createStream(wanted)) throw CInvalidArgument();
        policy = toCORBA(wanted);
    }
    const RemoteChannel::Pointer channel = newChannel(RemoteChannel::End::Writer, output, wanted);
    if (isOutOfBand(wanted)) return channel->reference();
    const base::ChannelElementBase::shared_ptr storage =
        internal::ConnFactory::makeChannelInput(output, ofOneConnection(wanted));
    if (storage) storage->connectTo(channel);
    if (!storage || !output.addConnection(newId(), storage, ofOneConnection(wanted))) {
        channel->leave();
        throw CInvalidArgument();
    }
    return channel->reference();
}

CORBA::Boolean DataFlowServant::createConnection(const char* local_port, CDataFlowInterface_ptr remote_ports,
                                                 const char* remote_port, CConnPolicy& policy) {
    const ServedComponent::Use use(*served_);
    OutputPortInterface& output = outputPort(local_port);
    const ConnPolicy wanted = policyOf(policy);
    if (const Service::shared_ptr near = servedService(remote_ports); near && wanted.transport == 0) {
        PortInterface* const input = near->getPort(remote_port);
        return input && input->asInput() && output.createConnection(*input->asInput(), wanted);
    }
    // The other side asks because it has none: what is left of an earlier connection ends.
    const RemoteConnID former(remote_ports, remote_port);
    (void)output.getManager()->removeConnection(&former);
    RemoteInputPort input(output.getTypeInfo(), remote_ports, remote_port);
    const bool connected = output.createConnection(input, wanted);
    policy = toCORBA(wanted);
    return connected;
}

CORBA::Boolean DataFlowServant::createSharedConnection(const char* input_port, CConnPolicy& policy) {
    const ServedComponent::Use use(*served_);
    InputPortInterface& input = inputPort(input_port);
    const ConnPolicy wanted = policyOf(policy);
    const auto shared = internal::SharedConnectionRepository::Instance().get(wanted.name_id);
    if (!shared) return false;
    if (!internal::ConnFactory::createSharedConnection(nullptr, &input, shared, wanted)) throw CInvalidArgument();
    policy = toCORBA(wanted);
    return true;
}

CORBA::Boolean DataFlowServant::removeConnection(const char* local_port, CDataFlowInterface_ptr remote_ports,
                                                 const char* remote_port) {
    const ServedComponent::Use use(*served_);
    OutputPortInterface& output = outputPort(local_port);
    if (const Service::shared_ptr near = servedService(remote_ports)) {
        PortInterface* const input = near->getPort(remote_port);
        if (input && output.disconnect(input)) return true;
    }
    const RemoteConnID id(remote_ports, remote_port);
    return output.getManager()->removeConnection(&id);
}

CORBA::Boolean DataFlowServant::createStream(const char* local_port, CConnPolicy& policy) {
    const ServedComponent::Use use(*served_);
    const ConnPolicy wanted = policyOf(policy);
    const bool created = port(local_port).createStream(wanted);
    policy = toCORBA(wanted);
    return created;
}

void DataFlowServant::removeStream(const char* local_port, const char* stream_name) {
    const ServedComponent::Use use(*served_);
    const internal::StreamConnID id(stream_name);
    (void)port(local_port).getManager()->removeConnection(&id);
}

}  // namespace RTT::corba::detail
