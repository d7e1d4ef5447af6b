// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_PORT_TABLE_HPP
#define OROFORGE_CONSOLE_PORT_TABLE_HPP

#include "screen.hpp"

namespace RTT {
class DataFlowInterface;
}

namespace OCL::console {

/** Writes direction, name, type, connections and documentation of ports, and the last value of outputs that keep it.
    Neither reads nor connects a port. */
void writePorts(Screen& screen, RTT::DataFlowInterface& ports, const std::string& indent);

}  // namespace OCL::console

#endif
