// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_CLANG_BASE_NEEDED_FILES_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_NEEDED_FILES_HPP

#include <vector>

#include "include_watch.hpp"

namespace oroforge::cxx {

/// Returns, for each file and each need of its words and macros, the other files any of which meets that need.
std::vector<std::vector<std::vector<std::size_t>>> neededFiles(const IncludeWatch& read,
                                                               const clang::ASTContext& context);

}  // namespace oroforge::cxx

#endif
