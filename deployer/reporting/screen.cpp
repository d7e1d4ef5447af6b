// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Writes the present interface of a component.
#include <ocl/ReportingComponent.hpp>

#include "report_name.hpp"

#include <rtt/Logger.hpp>

#include <ostream>

namespace OCL {

bool ReportingComponent::screenComponent(const std::string& component) {
    RTT::log(RTT::Error) << "'" << getName() << "' does not say where the screen of '" << component
                         << "' goes, because this kind of reporter has no screenComponent() of its own"
                         << RTT::endlog();
    return false;
}

bool ReportingComponent::screenImpl(const std::string& component, std::ostream& output) {
    RTT::TaskContext* const peer = getPeer(component);
    if (!peer) {
        RTT::log(RTT::Error) << "could not screen component '" << component << "': no such peer" << RTT::endlog();
        return false;
    }
    if (reporting::hasControl(component)) {
        RTT::log(RTT::Error) << "could not screen component '" << component
                             << "': its name has a control character, such as a line end" << RTT::endlog();
        return false;
    }
    output << "Screening Component '" << component << "' : \n\n";
    output << "Properties :\n";
    for (const RTT::base::PropertyBase* property : *peer->properties())
        output << "  " << property->getName() << " : " << property->getDataSource() << "\n";
    output << "Attributes :\n";
    for (const std::string& name : peer->attributes()->getAttributeNames())
        output << "  " << name << " : " << peer->attributes()->getValue(name)->getDataSource() << "\n";
    output << "Ports :\n";
    for (const RTT::base::PortInterface* port : peer->ports()->getPorts())
        output << "  " << port->getName() << " : " << (port->connected() ? "(connected)" : "(not connected)") << "\n";
    output.flush();
    return true;
}

}  // namespace OCL
