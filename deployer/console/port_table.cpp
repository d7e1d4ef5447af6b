// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "port_table.hpp"

#include "known_ports.hpp"
#include "table.hpp"
#include "type_name.hpp"
#include "value_text.hpp"

#include <rtt/DataFlowInterface.hpp>
#include <rtt/internal/ConnectionManager.hpp>

namespace OCL::console {
namespace {

constexpr std::size_t kMostNamed = 2;

std::string partnersOf(const RTT::base::PortInterface& port) {
    const bool input = port.asInput();
    const auto connections = port.getManager()->getConnections();
    if (connections.empty()) return port.connected() ? "connected" : "not connected";
    if (connections.size() > kMostNamed) return std::to_string(connections.size()) + " connections";
    std::string names;
    for (const auto& connection : connections) {
        const auto& id = connection.get<0>();
        names += (names.empty() ? "" : ", ") + (id->peer() ? id->peer()->getFullName() : id->toString());
    }
    return (input ? "<- " : "-> ") + names;
}

}  // namespace

void writePorts(Screen& screen, RTT::DataFlowInterface& ports, const std::string& indent,
                const std::vector<Gate>& around) {
    Table table({Style::Faint, Style::Name, Style::Type, Style::Value, Style::Plain, Style::Faint});
    {
        Visits visits;  // over before the terminal may block
        const KnownPorts known(around, visits);
        for (const RTT::base::PortInterface* const port : ports.getPorts()) {
            const auto last = known.lastSample(*port);
            table.add({port->asInput() ? "in" : "out", port->getName(), dotted(port->getTypeInfo()->getTypeName()),
                       last ? "= " + shortened(valueOnOneLine(valueText(last, screen.hex)), screen.valueWidth()) : "",
                       partnersOf(*port), oneLine(port->getDescription())});
        }
    }
    table.write(screen.out, screen.theme, indent, screen.tableWidth());
}

}  // namespace OCL::console
