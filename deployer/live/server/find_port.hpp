// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_FIND_PORT_HPP
#define OROFORGE_LIVE_FIND_PORT_HPP

#include "../samples/port_watch.hpp"

#include <rtt/internal/engine/engine_gate.hpp>

#include <memory>
#include <string>

namespace OCL::live {

/** Watches an output port of a component that others may destroy meanwhile. The path begins at the deployer. Null, with
    the reason, if that fails: "there is no …", or why the port cannot be watched. */
std::unique_ptr<PortWatch> watchPort(const boost::intrusive_ptr<const RTT::internal::EngineGate>& deployer,
                                     const std::string& path, const PortWatch::Options& options, std::string& why);

}  // namespace OCL::live

#endif
