// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds include folders of other packages with pkg-config (option -i).
#ifndef OROFORGE_TYPEKIT_GEN_COLLECT_IMPORT_PACKAGE_HPP
#define OROFORGE_TYPEKIT_GEN_COLLECT_IMPORT_PACKAGE_HPP

#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::typekit {

/// Returns the -I flags of PACKAGE-typekit-TARGET, PACKAGE-TARGET or PACKAGE, whichever pkg-config knows first; nothing
/// and error TK004 if it knows none of them. Blocks, because it runs programs.
std::vector<std::string> importFlags(const std::string& package, const std::string& target, diag::Sink& sink);

}  // namespace oroforge::typekit

#endif
