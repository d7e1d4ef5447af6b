// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/port_object.hpp>

#include <rtt/base/PortInterface.hpp>
#include <rtt/internal/flow/reclaimer.hpp>

namespace RTT::internal {

PortObject::PortObject(base::PortInterface& port) : Service(port.getName()), endpoint_(port.getEndpoint()) {
    addCommonLater();
}

// An operation that is added to the object may replace one of the port.
bool PortObject::isCommon(const std::string&) const { return true; }

void PortObject::addCommon() {
    const Reclaimer::Guard guard;  // the port's destructor waits meanwhile
    if (base::PortInterface* const port = endpoint_ ? endpoint_->getPort() : nullptr) port->addOperationsTo(*this);
}

}  // namespace RTT::internal
