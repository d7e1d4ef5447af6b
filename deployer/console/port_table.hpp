// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_PORT_TABLE_HPP
#define OROFORGE_CONSOLE_PORT_TABLE_HPP

#include "screen.hpp"

namespace RTT {
class DataFlowInterface;
}

namespace OCL::console {

/** Direction, name, type, the last value of an output that keeps it, what it is connected to, documentation. Reads from no port
    and connects none. */
void writePorts(Screen& screen, RTT::DataFlowInterface& ports, const std::string& indent);

}  // namespace OCL::console

#endif
