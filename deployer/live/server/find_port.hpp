// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_FIND_PORT_HPP
#define OROFORGE_LIVE_FIND_PORT_HPP

#include "../requests/lookup.hpp"
#include "../samples/port_watch.hpp"

#include <memory>
#include <string>

namespace OCL::live {

/** Watches an output port of a component that others may destroy meanwhile. Throws Failure if there is none at the
    path, or it cannot be watched. */
std::unique_ptr<PortWatch> watchPort(const Root& root, const std::string& path, const PortWatch::Options& options);

}  // namespace OCL::live

#endif
