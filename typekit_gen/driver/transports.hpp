// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Which transports types are generated for: ways to send them between processes.
#ifndef OROFORGE_TYPEKIT_GEN_DRIVER_TRANSPORTS_HPP
#define OROFORGE_TYPEKIT_GEN_DRIVER_TRANSPORTS_HPP

#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::typekit {

/// All that packages name in -t and -n.
const std::vector<std::string>& knownTransports();

/// Those that this toolchain can generate, and generates when nobody asks. None: it has no part that sends between
/// processes yet. Who adds one lists it here.
const std::vector<std::string>& installedTransports();

/// The wanted ones but for the unwanted. Errors: TK003 for names that nobody knows, TK068 for what is not installed.
std::vector<std::string> chooseTransports(const std::vector<std::string>& wanted,
                                          const std::vector<std::string>& unwanted, diag::Sink& sink);

}  // namespace oroforge::typekit

#endif
