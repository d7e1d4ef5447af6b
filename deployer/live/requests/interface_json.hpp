// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The parts of a component's interface as JSON. Call these while the component is visited.
#ifndef OROFORGE_LIVE_INTERFACE_JSON_HPP
#define OROFORGE_LIVE_INTERFACE_JSON_HPP

#include "ports.hpp"
#include "values.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace OCL::live {

/** "Running", "Stopped" … */
const char* stateOf(RTT::TaskContext& component);
/** The type that the deployer created, or that of the C++ class. */
std::string classOf(RTT::TaskContext& component);

/** {name, type, writable, doc, unit}; no value. */
nlohmann::json propertyHead(const RTT::base::PropertyBase& property);
nlohmann::json attributeHead(const RTT::base::AttributeBase& attribute);
nlohmann::json operationJson(const RTT::OperationInterfacePart& part);
/** With the text of the last sample, of at most `most` bytes. */
nlohmann::json portJson(const RTT::base::PortInterface& port, const KnownPorts& known, std::size_t most);

/** Adds "value" and "text" to what describes a value. The texts of one answer share `left` bytes, and values get as
    much; `cut: true` says that something was left out. */
void addValue(nlohmann::json& to, const Source& value, std::size_t& left);

}  // namespace OCL::live

#endif
