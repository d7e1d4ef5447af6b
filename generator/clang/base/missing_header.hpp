// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds a header that the compiler did not find.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_MISSING_HEADER_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_MISSING_HEADER_HPP

#include <string>

namespace oroforge::cxx {

/// Returns the option with which `includer` finds `<name>`: searches the package of `includer`, packages beside it, and
/// below /usr/include. For headers of the toolchain it names their package. Empty if nothing is found.
std::string folderHint(const std::string& name, const std::string& includer);

}  // namespace oroforge::cxx

#endif
