// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_PORT_TABLE_HPP
#define OROFORGE_CONSOLE_PORT_TABLE_HPP

#include "screen.hpp"
#include "visits.hpp"

#include <string>
#include <vector>

namespace RTT {
class DataFlowInterface;
}

namespace OCL::console {

/** Writes direction, name, type, last sample, connections and documentation of ports. The sample of an input port is
    the last one that an output port of `around` or their peers wrote to it. Neither reads nor connects a port. */
void writePorts(Screen& screen, RTT::DataFlowInterface& ports, const std::string& indent,
                const std::vector<Gate>& around);

}  // namespace OCL::console

#endif
