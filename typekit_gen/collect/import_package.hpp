// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Include folders of other packages, from pkg-config (option -i).
#ifndef OROFORGE_TYPEKIT_GEN_COLLECT_IMPORT_PACKAGE_HPP
#define OROFORGE_TYPEKIT_GEN_COLLECT_IMPORT_PACKAGE_HPP

#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::typekit {

/// The -I flags of PACKAGE-typekit-TARGET, PACKAGE-TARGET or PACKAGE, whichever pkg-config knows first;
/// none and an error TK004 if it knows none of them. Runs programs, so it blocks.
std::vector<std::string> importFlags(const std::string& package, const std::string& target, diag::Sink& sink);

}  // namespace oroforge::typekit

#endif
