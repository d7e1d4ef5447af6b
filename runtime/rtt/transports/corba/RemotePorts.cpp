// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/RemotePorts.hpp>

#include <rtt/DataFlowInterface.hpp>
#include <rtt/Logger.hpp>
#include <rtt/Service.hpp>
#include <rtt/internal/ConnFactory.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/flow/stream_sender.hpp>
#include <rtt/transports/corba/CorbaConnPolicy.hpp>
#include <rtt/transports/corba/CorbaLib.hpp>
#include <rtt/transports/corba/RemoteConnID.hpp>
#include <rtt/transports/corba/ServiceC.h>
#include <rtt/transports/corba/detail/expected_channel.hpp>
#include <rtt/transports/corba/detail/later.hpp>
#include <rtt/transports/corba/detail/lost_connections.hpp>
#include <rtt/transports/corba/detail/policies.hpp>
#include <rtt/transports/corba/detail/remote_channel.hpp>
#include <rtt/transports/corba/detail/remote_peer.hpp>
#include <rtt/transports/corba/detail/served_components.hpp>
#include <rtt/transports/corba/detail/serving.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <memory>
#include <optional>
#include <stdexcept>

namespace RTT::corba {

namespace {

using detail::completed;
using detail::RemoteChannel;

/** The reference of the interface of a port of this process; nil, with an error logged, if it belongs to no
    component. */
CDataFlowInterface_var interfaceOf(const base::PortInterface& port) {
    const DataFlowInterface* const own = port.getInterface();
    if (own && own->getService()) {
        const CService_var service = detail::serve(*own->getService());
        if (!CORBA::is_nil(service)) return CDataFlowInterface::_duplicate(service);
    }
    log(Error) << "port " << port.getFullName()
               << " cannot be connected with another process: it belongs to no component" << endlog();
    return CDataFlowInterface::_nil();
}

}  // namespace

template <class Base>
RemotePort<Base>::RemotePort(const types::TypeInfo* type, CDataFlowInterface_ptr interface, const std::string& name)
    : Base(name), lost_(std::make_shared<detail::LostConnections>()), type_(type) {
    attach(interface);
}

template <class Base>
RemotePort<Base>::~RemotePort() {
    attach(CDataFlowInterface::_nil());
}

template <class Base>
void RemotePort<Base>::attach(CDataFlowInterface_ptr interface) {
    const CDataFlowInterface_var own = detail::limited<CDataFlowInterface>(interface);
    const std::lock_guard<std::mutex> lock(mutex_);
    interface_ = own;
}

template <class Base>
CDataFlowInterface_ptr RemotePort<Base>::getDataFlowInterface() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return CDataFlowInterface::_duplicate(interface_);
}

template <class Base>
template <class Result, class Call>
Result RemotePort<Base>::ask(const char* wanted, Result otherwise, Call call) const {
    CDataFlowInterface_var interface;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!isLost_) interface = interface_;
    }
    if (CORBA::is_nil(interface)) return otherwise;
    try {
        return detail::whileServing([&] { return call(interface.in()); });
    } catch (const CORBA::Exception& error) {
        log(Error) << "port " << this->getFullName() << " of another process " << wanted << ": "
                   << detail::describe(error) << endlog();
        return otherwise;
    }
}

template <class Base>
int RemotePort<Base>::serverProtocol() const {
    return ORO_CORBA_PROTOCOL_ID;
}

template <class Base>
bool RemotePort<Base>::connected() const {
    return ask("does not tell whether it is connected", false, [this](CDataFlowInterface_ptr interface) -> bool {
        return interface->isConnected(this->getName().c_str());
    });
}

template <class Base>
bool RemotePort<Base>::connectedTo(base::PortInterface* port) const {
    if (!port || !port->isLocal()) return false;
    const CDataFlowInterface_var interface = getDataFlowInterface();
    if (CORBA::is_nil(interface)) return false;
    const RemoteConnID id(interface, this->getName());
    for (const auto& connection : port->getManager()->getConnections())
        if (id.isSameID(*connection.template get<0>())) return true;
    return false;
}

template <class Base>
void RemotePort<Base>::disconnect() {
    (void)ask("is not disconnected", false, [this](CDataFlowInterface_ptr interface) {
        interface->disconnectPort(this->getName().c_str());
        return true;
    });
}

template <class Base>
bool RemotePort<Base>::disconnect(base::PortInterface* port) {
    if (!port) return false;
    if (port->isLocal()) {
        const RemoteConnID id(CDataFlowInterface_var(getDataFlowInterface()), this->getName());
        return port->getManager()->removeConnection(&id);
    }
    auto* const output =
        dynamic_cast<RemoteOutputPort*>(this->asOutput() ? static_cast<base::PortInterface*>(this) : port);
    auto* const input =
        dynamic_cast<RemoteInputPort*>(this->asOutput() ? port : static_cast<base::PortInterface*>(this));
    if (!output || !input) return false;
    return ask("is not disconnected", false, [&](CDataFlowInterface_ptr) -> bool {
        const CDataFlowInterface_var from = output->getDataFlowInterface(), to = input->getDataFlowInterface();
        return !CORBA::is_nil(from) && from->removeConnection(output->getName().c_str(), to, input->getName().c_str());
    });
}

template <class Base>
bool RemotePort<Base>::createStream(ConnPolicy const& policy) {
    return ask("has no stream", false, [&](CDataFlowInterface_ptr interface) -> bool {
        CConnPolicy given = toCORBA(policy);
        const bool created = interface->createStream(this->getName().c_str(), given);
        policy.name_id = given.name_id.in();
        policy.data_size = given.data_size;
        return created;
    });
}

template <class Base>
void RemotePort<Base>::lost() {
    lost_->ended();
    const std::lock_guard<std::mutex> lock(mutex_);
    isLost_ = true;
}

template <class Base>
void RemotePort<Base>::restore() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        isLost_ = false;
    }
    lost_->restore([this](base::PortInterface& port, const ConnPolicy& policy) {
        return connectedTo(&port) || port.connectTo(this, policy);
    });
}

template class RemotePort<base::InputPortInterface>;
template class RemotePort<base::OutputPortInterface>;

namespace {

/** Ends both ends of a connection that does not come about. */
class Attempt {
public:
    explicit Attempt(CRemoteChannelElement_ptr remote) : remote_(CRemoteChannelElement::_duplicate(remote)) {}
    ~Attempt() {
        if (isDone) return;
        if (channel) channel->leave();
        detail::later([remote = remote_] { remote->disconnect(); });
    }
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;

    RemoteChannel::Pointer channel;
    bool isDone = false;

private:
    const CRemoteChannelElement_var remote_;
};

/** By a stream of another transport, whose ends both processes make. The channels tell each other of their end. */
bool joinOutOfBand(base::OutputPortInterface& output, const RemoteConnID& input, const ConnPolicy& policy,
                   const detail::LostConnections::Ended& ended) {
    const bool isForOthersToo = !policy.name_id.empty();
    const RemoteChannel::Pointer channel =
        RemoteChannel::make(RemoteChannel::End::Writer, *output.getTypeInfo(), policy, output.getFullName());
    if (!channel) return false;
    const base::ChannelElementBase::shared_ptr stream =
        internal::ConnFactory::createStream(output, policy, std::unique_ptr<internal::ConnID>(input.clone()), channel);
    if (!stream) {
        channel->leave();
        return false;
    }
    const auto isJoined = [&]() -> bool {
        CConnPolicy given = toCORBA(policy);
        const CChannelElement_var element = input.dataflow->buildChannelOutput(input.name.c_str(), given);
        const CRemoteChannelElement_var remote = CRemoteChannelElement::_narrow(element);
        if (CORBA::is_nil(remote)) return false;
        Attempt attempt(detail::limited<CRemoteChannelElement>(remote));
        channel->setRemoteSide(remote);
        remote->setRemoteSide(CRemoteChannelElement_var(channel->reference()));
        return attempt.isDone = remote->channelReady(given);
    };
    try {
        if (isJoined()) {
            channel->whenEnded(ended);
            auto* const sender = isForOthersToo ? nullptr : dynamic_cast<internal::StreamSender*>(stream.get());
            if (sender) sender->withdrawName();
            return true;
        }
    } catch (const CORBA::Exception&) {
        (void)output.getManager()->removeConnection(&input);
        throw;
    }
    (void)output.getManager()->removeConnection(&input);
    return false;
}

}  // namespace

// The channel in this process comes first, so that the other one knows both ends when it is ready.
bool RemoteInputPort::connectFrom(base::OutputPortInterface& output, ConnPolicy const& policy) {
    const ConnPolicy wanted = completed(policy);
    const types::TypeInfo* const type = output.getTypeInfo();
    if (!type || type != getTypeInfo()) {
        log(Error) << "output port " << output.getFullName() << " of type "
                   << (type ? type->getTypeName() : std::string("unknown_t")) << " is not compatible with input port "
                   << getFullName() << " of type " << (getTypeInfo() ? getTypeInfo()->getTypeName() : "unknown_t")
                   << " of another process" << endlog();
        return false;
    }
    if (wanted.buffer_policy == Shared) {
        log(Error) << "port " << getFullName()
                   << " of another process cannot be connected: connections with the buffer "
                   << "policy Shared do not cross processes" << endlog();
        return false;
    }
    return ask("cannot be connected", false, [&](CDataFlowInterface_ptr interface) -> bool {
        if (detail::isOutOfBand(wanted)) {
            const bool isJoined = joinOutOfBand(output, RemoteConnID(interface, getName(), getFullName()), wanted,
                                                lost_->remember(output, policy));
            policy.name_id = wanted.name_id;
            return isJoined;
        }
        CConnPolicy given = toCORBA(wanted);
        const CChannelElement_var element = interface->buildChannelOutput(getName().c_str(), given);
        const CRemoteChannelElement_var remote = CRemoteChannelElement::_narrow(element);
        if (CORBA::is_nil(remote)) return false;
        Attempt attempt(detail::limited<CRemoteChannelElement>(remote));
        const RemoteChannel::Pointer channel =
            RemoteChannel::make(RemoteChannel::End::Writer, *type, wanted, output.getFullName());
        attempt.channel = channel;
        if (!channel) return false;
        const ConnPolicy own = detail::ofOneConnection(wanted);
        const base::ChannelElementBase::shared_ptr storage = internal::ConnFactory::makeChannelInput(output, own);
        if (!storage) return false;
        channel->setRemoteSide(remote);
        storage->connectTo(channel);
        remote->setRemoteSide(CRemoteChannelElement_var(channel->reference()));
        if (!remote->channelReady(given)) return false;
        policy.name_id = given.name_id.in();
        channel->whenEnded(lost_->remember(output, policy));
        attempt.isDone = output.addConnection(new RemoteConnID(interface, getName(), getFullName()), storage, own);
        return attempt.isDone;
    });
}

base::DataSourceBase* RemoteInputPort::getDataSource() {
    throw std::runtime_error("a port of another process cannot be read");
}
base::DataSourceBase* RemoteOutputPort::getDataSource() const {
    throw std::runtime_error("a port of another process cannot be read");
}

bool RemoteOutputPort::createConnection(base::InputPortInterface& sink, ConnPolicy const& policy) {
    auto* const remote = dynamic_cast<RemoteInputPort*>(&sink);
    const CDataFlowInterface_var theirs =
        remote ? CDataFlowInterface_var(remote->getDataFlowInterface()) : interfaceOf(sink);
    if (CORBA::is_nil(theirs)) return false;
    return ask("cannot be connected", false, [&](CDataFlowInterface_ptr interface) -> bool {
        std::optional<detail::ExpectedChannel> expected;
        if (!remote)
            expected.emplace(sink, RemoteConnID(interface, getName(), getFullName()), lost_->remember(sink, policy),
                             detail::isOutOfBand(policy));
        CConnPolicy given = toCORBA(completed(policy));
        const bool isNamed = expected && !expected->name().empty() && policy.buffer_policy != Shared;
        if (isNamed) given.name_id = expected->name().c_str();
        const bool connected = interface->createConnection(getName().c_str(), theirs, sink.getName().c_str(), given);
        if (!isNamed) policy.name_id = given.name_id.in();
        policy.data_size = given.data_size;
        return connected;
    });
}

base::PortInterface* RemoteInputPort::clone() const { return getTypeInfo()->inputPort(getName()); }
base::PortInterface* RemoteInputPort::antiClone() const { return getTypeInfo()->outputPort(getName()); }
base::PortInterface* RemoteOutputPort::clone() const { return getTypeInfo()->outputPort(getName()); }
base::PortInterface* RemoteOutputPort::antiClone() const { return getTypeInfo()->inputPort(getName()); }

}  // namespace RTT::corba
