// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Where a header is that the compiler did not find.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_MISSING_HEADER_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_MISSING_HEADER_HPP

#include <string>

namespace oroforge::cxx {

/// The option to pass so that `includer` finds `<name>`: looked for in the package of `includer`, in those beside it, and below
/// /usr/include. For headers of the toolchain, which stands elsewhere, its package. Empty if nothing is known.
std::string folderHint(const std::string& name, const std::string& includer);

}  // namespace oroforge::cxx

#endif
