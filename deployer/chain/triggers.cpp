// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The ports whose samples make a chain execute.
#include "impl.hpp"

#include <rtt/Logger.hpp>
#include <rtt/types/Types.hpp>

namespace OCL::chain {

void Impl::onSamples(RTT::base::InputPortInterface& port) {
    if (&port == &chain.trigger_port) {
        for (int sample = 0; chain.trigger_port.read(sample, false) == RTT::NewData;) cycle();
        return;
    }
    if (&port == &chain.clock_port) {
        for (double sample = 0; chain.clock_port.read(sample, false) == RTT::NewData;) cycle();
        return;
    }
}

/** A port of the property `triggers`, "port" or "port:type", with the place for its samples. */
void Impl::addTriggers(std::vector<std::string>& findings) {
    for (const std::string& entry : properties.triggers) {
        const std::size_t colon = entry.find(':');
        const std::string name = entry.substr(0, colon);
        const RTT::types::TypeInfo* const type =
            colon == std::string::npos ? nullptr : RTT::types::Types()->type(entry.substr(colon + 1));
        RTT::base::PortInterface* port = chain.getPort(name);
        if (!port && colon != std::string::npos && !type) {
            findings.push_back("the type of trigger '" + entry + "' is unknown; import the typekit that has it");
            continue;
        }
        if (!port && type) {
            std::unique_ptr<RTT::base::InputPortInterface> made(type->inputPort(name));
            if (made) {
                chain.addPort(*made).doc("Each sample is one cycle.");
                port = made.get();
                ownPorts.push_back(std::move(made));
            }
        }
        RTT::base::InputPortInterface* const input = port ? port->asInput() : nullptr;
        if (!input || !input->getTypeInfo()) {
            findings.push_back("trigger '" + entry + "' is no input port of '" + chain.getName() +
                               "'; write \"name:type\" to have one made");
            continue;
        }
        if (input == &chain.trigger_port || input == &chain.clock_port) continue;
        const RTT::base::DataSourceBase::shared_ptr sample = input->getTypeInfo()->buildValue();
        if (!sample) {
            findings.push_back("the samples of trigger '" + entry + "' cannot be read: no typekit has their type");
            continue;
        }
        chain.ports()->setEventPort(*input, [this, input, sample](RTT::base::PortInterface*) {
            while (input->read(sample, false) == RTT::NewData) cycle();
        });
    }
}

}  // namespace OCL::chain
