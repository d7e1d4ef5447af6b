// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_PORTS_HPP
#define OROFORGE_LIVE_PORTS_HPP

#include <console/known_ports.hpp>

#include <string>

namespace OCL::live {

using console::KnownPorts;

std::string typeOfPort(const RTT::base::PortInterface& port);

}  // namespace OCL::live

#endif
