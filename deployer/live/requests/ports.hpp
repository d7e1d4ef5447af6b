// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_PORTS_HPP
#define OROFORGE_LIVE_PORTS_HPP

#include <console/known_ports.hpp>
#include <rtt/ConnPolicy.hpp>

#include <string>

namespace OCL::live {

using console::KnownPorts;

/** "data", "buffer 10", "circular buffer 10". */
std::string policyText(const RTT::ConnPolicy& policy);
std::string typeOfPort(const RTT::base::PortInterface& port);

}  // namespace OCL::live

#endif
