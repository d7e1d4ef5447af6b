// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_CLANG_BASE_NEEDED_FILES_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_NEEDED_FILES_HPP

#include <vector>

#include "include_watch.hpp"

namespace oroforge::cxx {

/// For each file what its words and macros need that it does not have itself: one of those files, for each need.
std::vector<std::vector<std::vector<std::size_t>>> neededFiles(const IncludeWatch& read,
                                                               const clang::ASTContext& context);

}  // namespace oroforge::cxx

#endif
