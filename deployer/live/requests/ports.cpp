// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ports.hpp"

#include "verbs.hpp"

#include <console/type_name.hpp>
#include <rtt/base/OutputPortInterface.hpp>

#include <utility>

namespace OCL::live {

using RTT::base::PortInterface;

std::string typeOfPort(const PortInterface& port) { return console::dotted(port.getTypeInfo()->getTypeName()); }

/** The verb `ports`. */
nlohmann::json ports(const Asked& asked) {
    Visits visits;
    const KnownPorts known({asked.root.gate}, visits);
    nlohmann::json outputs = nlohmann::json::array();
    for (const KnownPorts::Port& at : known.all())
        if (at.port->asOutput()) outputs.push_back(at.component + "." + at.name);
    return {{"outputs", std::move(outputs)}};
}

}  // namespace OCL::live
