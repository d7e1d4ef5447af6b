// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/DataFlowInterface.hpp>

#include <rtt/Logger.hpp>
#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>

#include <algorithm>

namespace RTT {

using base::InputPortInterface;
using base::PortInterface;

DataFlowInterface::DataFlowInterface(Service* parent) : service_(parent) {}

DataFlowInterface::~DataFlowInterface() {
    service_ = nullptr;  // the derived part is gone; an owner of callbacks has called clear() before
    clear();
}

TaskContext* DataFlowInterface::getOwner() const { return service_ ? service_->getOwner() : nullptr; }

PortInterface& DataFlowInterface::addPort(const std::string& name, PortInterface& port) {
    port.setName(name);
    return addPort(port);
}

PortInterface& DataFlowInterface::addPort(PortInterface& port) {
    addLocalPort(port);
    if (service_) {
        if (service_->hasService(port.getName())) {
            log(Warning) << "'" << service_->getName() << "': service '" << port.getName()
                         << "' is replaced by the one of the port with this name" << endlog();
            service_->removeService(port.getName());
        }
        const boost::shared_ptr<Service> object(port.createPortObject());
        service_->addService(object);
        objects_[&port] = object;
    }
    return port;
}

InputPortInterface& DataFlowInterface::addEventPort(const std::string& name, InputPortInterface& port,
                                                    const SlotFunction& callback) {
    port.setName(name);
    return addEventPort(port, callback);
}

InputPortInterface& DataFlowInterface::addEventPort(InputPortInterface& port, const SlotFunction& callback) {
    addPort(port);
    setupCallback(port, callback);
    return port;
}

bool DataFlowInterface::setEventPort(InputPortInterface& port, const SlotFunction& callback) {
    if (getOwner() && port.getInterface() == this) {
        setupCallback(port, callback);
        return true;
    }
    log(Error) << "port " << port.getFullName() << " is not of this component: it cannot become an event port of it"
               << endlog();
    return false;
}

PortInterface& DataFlowInterface::addLocalPort(PortInterface& port) {
    replacePort(port.getName());
    if (DataFlowInterface* other = port.getInterface()) other->forgetPort(port);
    ports_.push_back(&port);
    port.setInterface(this);
    return port;
}

InputPortInterface& DataFlowInterface::addLocalEventPort(InputPortInterface& port, const SlotFunction& callback) {
    addLocalPort(port);
    setupCallback(port, callback);
    return port;
}

void DataFlowInterface::replacePort(const std::string& name) {
    if (!getPort(name)) return;
    log(Warning) << "'" << (service_ ? service_->getName() : std::string("(no service)")) << "': port name '" << name
                 << "' is in use already; the previous port is disconnected and replaced" << endlog();
    removePort(name);
}

void DataFlowInterface::setupCallback(InputPortInterface& port, const SlotFunction& callback) {
    TaskContext* owner = getOwner();
    if (!owner) {
        log(Error) << "port " << port.getFullName()
                   << " is in no component: its new samples will trigger nothing and call nothing" << endlog();
        return;
    }
    owner->setDataOnPortCallback(&port, callback);
    port.signalInterface(true);
}

void DataFlowInterface::removePort(const std::string& name) {
    PortInterface* port = getPort(name);
    if (!port) return;
    port->disconnect();
    forgetPort(*port);
}

void DataFlowInterface::removeLocalPort(const std::string& name) { removePort(name); }

void DataFlowInterface::forgetPort(PortInterface& port) {
    const auto found = std::find(ports_.begin(), ports_.end(), &port);
    if (found == ports_.end()) return;
    ports_.erase(found);
    takeOut(port);
    removeObject(port);
}

// By identity: the port may have another name by now, and another service may have its name.
void DataFlowInterface::removeObject(PortInterface& port) {
    const auto found = objects_.find(&port);
    if (found == objects_.end()) return;
    const boost::shared_ptr<Service> object = found->second;
    objects_.erase(found);
    if (service_ && service_->getService(object->getName()) == object) service_->removeService(object->getName());
}

void DataFlowInterface::clear() {
    Ports ports;
    ports.swap(ports_);
    for (PortInterface* port : ports) {
        takeOut(*port);
        removeObject(*port);
    }
}

void DataFlowInterface::silencePorts() {
    const auto isOurs = [this](PortInterface* port) {
        return std::find(ports_.begin(), ports_.end(), port) != ports_.end();
    };
    // takeOut() may execute messages, which may remove other ports.
    for (PortInterface* port : getPorts()) {
        if (isOurs(port)) takeOut(*port);
        if (isOurs(port)) port->setInterface(this);
    }
}

/** Afterwards the port does not refer to this, and no thread signals its samples to this. */
void DataFlowInterface::takeOut(PortInterface& port) {
    port.setInterface(nullptr);
    InputPortInterface* input = port.asInput();
    if (!input) return;
    input->signalInterface(false);
    TaskContext* const owner = getOwner();
    // A thread that signals the component may be waiting for a message to this thread. Within the component's own step
    // no messages are executed, because it may be under destruction.
    input->finishSignals(owner && !owner->engine()->isStepping());
    if (owner) owner->dataOnPortRemoved(input);
}

DataFlowInterface::PortNames DataFlowInterface::getPortNames() const {
    PortNames names;
    for (const PortInterface* port : ports_) names.push_back(port->getName());
    return names;
}

PortInterface* DataFlowInterface::getPort(const std::string& name) const {
    for (PortInterface* port : ports_)
        if (port->getName() == name) return port;
    return nullptr;
}

std::string DataFlowInterface::getPortDescription(const std::string& name) const {
    const PortInterface* port = getPort(name);
    return port ? port->getDescription() : std::string();
}

bool DataFlowInterface::setPortDescription(const std::string& name, const std::string& description) {
    PortInterface* port = getPort(name);
    if (port) port->doc(description);
    return port != nullptr;
}

void DataFlowInterface::dataOnPort(PortInterface* port) {
    if (TaskContext* owner = getOwner()) owner->dataOnPort(port);
}

}  // namespace RTT
