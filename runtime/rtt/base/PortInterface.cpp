// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/PortInterface.hpp>

#include <rtt/DataFlowInterface.hpp>
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/flow/channel_array.hpp>
#include <rtt/internal/flow/port_endpoint.hpp>
#include <rtt/internal/flow/port_object.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/types/TypeInfo.hpp>

namespace RTT::base {

PortInterface::PortInterface(const std::string& name, const types::TypeOps* ops)
    : name_(name),
      ops_(ops),
      endpoint_(new internal::PortEndpoint(*this)),
      manager_(new internal::ConnectionManager(this)) {}

PortInterface::~PortInterface() = default;

void PortInterface::leaveInterface() {
    if (DataFlowInterface* iface = getInterface()) iface->forgetPort(*this);
}

void PortInterface::closeDown() {
    disconnect();
    leaveInterface();
    endpoint_->detach();
    internal::Reclaimer::synchronize();
}

std::string PortInterface::getFullName() const {
    const DataFlowInterface* iface = getInterface();
    std::string path = name_;
    for (Service* service = iface ? iface->getService() : nullptr; service; service = service->getParent().get())
        path = service->getName() + "." + path;
    return path;
}

bool PortInterface::setName(const std::string& name) {
    if (connected()) return false;
    name_ = name;
    return true;
}

PortInterface& PortInterface::doc(const std::string& text) {
    description_ = text;
    const DataFlowInterface* iface = getInterface();
    Service* service = iface ? iface->getService() : nullptr;
    if (service && service->hasService(name_)) service->getService(name_)->doc(text);
    return *this;
}

bool PortInterface::connected() const { return channels_.load(std::memory_order_acquire) != nullptr; }

bool PortInterface::connectedTo(PortInterface* port) const {
    // What stands for a port of another process knows the connections with ports of this one.
    if (port && isLocal() && !port->isLocal()) return port->connectedTo(const_cast<PortInterface*>(this));
    return manager_->connectedTo(port);
}

void PortInterface::disconnect() { manager_->disconnect(); }

bool PortInterface::disconnect(PortInterface* port) {
    return port && isLocal() && !port->isLocal() ? port->disconnect(this) : manager_->disconnect(port);
}

bool PortInterface::isLocal() const { return serverProtocol() == 0; }

int PortInterface::serverProtocol() const { return 0; }

bool PortInterface::addConnection(internal::ConnID* id, ChannelElementBase::shared_ptr channel,
                                  ConnPolicy const& policy) {
    if (id && channel) {
        manager_->addConnection(id, channel, policy);
        return true;
    }
    log(Error) << "port " << getFullName() << ": a connection without " << (id ? "channel" : "id") << " was refused"
               << endlog();
    delete id;
    return false;
}

bool PortInterface::removeConnection(internal::ConnID* id) { return manager_->removeConnection(id); }

void PortInterface::setInterface(DataFlowInterface* iface) {
    interface_.store(iface, std::memory_order_seq_cst);  // see InputPortInterface::finishSignals()
}

internal::SharedConnectionBase::shared_ptr PortInterface::getSharedConnection() const {
    return manager_->getSharedConnection();
}

ChannelElementBase::shared_ptr PortInterface::sharedStorage() const { return manager_->getSharedStorage(); }

bool PortInterface::createConnection(internal::SharedConnectionBase::shared_ptr shared_connection) {
    if (shared_connection) return createConnection(shared_connection, shared_connection->getPolicy());
    log(Error) << "port " << getFullName() << ": there is no shared connection to join" << endlog();
    return false;
}

ChannelElementBase* PortInterface::getEndpoint() const { return endpoint_.get(); }

internal::ConnID* PortInterface::getPortID() const { return new internal::LocalConnID(this); }

Service* PortInterface::createPortObject() {
    auto* const object = new internal::PortObject(*this);
    object->doc(description_.empty() ? "No description set for this Port. Use .doc() to document it." : description_);
    return object;
}

void PortInterface::addOperationsTo(Service& object) {
    object.addSynchronousOperation("name", [this] { return getName(); }).doc("Returns the port name.");
    object.addSynchronousOperation("connected", &PortInterface::connected, this)
        .doc("Does the port have a connection or stream?");
    typedef void (PortInterface::*Disconnect)();
    object.addSynchronousOperation("disconnect", static_cast<Disconnect>(&PortInterface::disconnect), this)
        .doc("Removes all connections and streams of the port.");
}

ChannelElementBase::shared_ptr PortInterface::buildStorage(ConnPolicy const&) const {
    log(Error) << "port " << getFullName() << " is a proxy: it has no storage of its own" << endlog();
    return nullptr;
}

}  // namespace RTT::base
