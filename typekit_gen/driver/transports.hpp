// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The transports that types are generated for; a transport sends values between processes.
#ifndef OROFORGE_TYPEKIT_GEN_DRIVER_TRANSPORTS_HPP
#define OROFORGE_TYPEKIT_GEN_DRIVER_TRANSPORTS_HPP

#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::typekit {

/// Returns every name that packages use with -t and -n.
const std::vector<std::string>& knownTransports();

/// Returns the transports of this toolchain. They read the tables of typekits, so nothing is generated for them.
const std::vector<std::string>& installedTransports();

/// Returns wanted transports without unwanted ones. Errors: TK003 for unknown names, TK068 for ones not installed.
std::vector<std::string> chooseTransports(const std::vector<std::string>& wanted,
                                          const std::vector<std::string>& unwanted, diag::Sink& sink);

}  // namespace oroforge::typekit

#endif
